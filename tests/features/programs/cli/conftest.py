"""Fixtures of the programs' commands."""

from tests.support.stand_ins import stand_ins

__all__ = ["stand_ins"]
