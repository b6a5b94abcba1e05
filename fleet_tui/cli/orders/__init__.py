"""Orders and other commands from a shell: checked, sent, awaited."""
