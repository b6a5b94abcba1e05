"""Set-up over rosbridge: names, messages and streams, the same for every kind of robots."""
