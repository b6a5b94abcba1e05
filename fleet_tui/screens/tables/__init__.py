"""What is done with rows: filter, marks, outcomes."""
