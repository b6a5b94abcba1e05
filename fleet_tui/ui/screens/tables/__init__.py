"""Actions on rows: filter, marks, outcomes."""
