"""The ablation: what each part of the method is worth, by switching it off."""
