"""The audit log as a page and as a command of the shell."""
