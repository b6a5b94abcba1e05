"""Tables: the rows of panes and pages."""
