"""What is seen: pure functions from the state to text, inks and cells."""
