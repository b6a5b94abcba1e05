"""The diagnostics screen."""
