"""One folder per feature: its rules, files, pages, and commands of the shell. None sees another."""
