"""The experiments of the paper over the user's data: runs, tables, figures, one report."""
