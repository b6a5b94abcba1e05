"""Lines: status, commands, hints, reasons."""
