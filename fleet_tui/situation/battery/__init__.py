"""Battery levels as this console saw them, and what they lead to."""
