"""Views: pure functions from the state to text, style roles and cells."""
