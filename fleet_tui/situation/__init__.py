"""What is wrong, decided once: pure functions that find a fact, and the table of its words."""
