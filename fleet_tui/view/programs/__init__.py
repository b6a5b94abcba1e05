"""Programs of robot servers as rows, questions and lines."""
