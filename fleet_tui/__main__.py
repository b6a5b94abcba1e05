"""`python -m fleet_tui` and the `fleet-tui` command."""

from fleet_tui.cli import main

__all__ = ["main"]

if __name__ == "__main__":
    main()
