"""How far the confidence can be believed."""
