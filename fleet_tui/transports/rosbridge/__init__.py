"""WebSockets to rosbridge servers."""
