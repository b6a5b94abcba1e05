"""Set-up over a link: listeners of its messages, streams beside the fleet state."""
