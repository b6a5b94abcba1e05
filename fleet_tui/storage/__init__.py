"""What all files of the console are made of: opening, locks, lines, whole files, and work beside a disk."""
