"""The history as it is read: events, pictures of robots and time, figures."""
