"""Graph files: text of each format to a document and back. Pure; one module for each format."""
