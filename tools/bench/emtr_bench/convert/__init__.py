"""Public sets that may not be passed on, from archives that the user has downloaded."""
