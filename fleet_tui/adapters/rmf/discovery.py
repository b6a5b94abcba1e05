"""Fleets of Open-RMF: their robots are named in messages only, not by topics."""

from fleet_tui.adapters.discovery import Discovery, Listed


def discover(listed: Listed) -> Discovery:
    """Return no robot: names of topics don't show any."""
    return Discovery()
