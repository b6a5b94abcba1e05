"""The graph editor: its draft, drawing, checks and files; `fleet-tui graph`."""
