"""Findings of the doctor."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from enum import Enum


class Verdict(Enum):
    """The verdict of a finding; `SKIPPED` if an earlier step failed, or the result is unknown."""

    OK = "ok"
    WARN = "warn"
    FAIL = "FAIL"
    SKIPPED = "skipped"


@dataclass(frozen=True, slots=True)
class Finding:
    """One line: subject, check, measurement, remedy, and the bare numbers.

    `out_of_time`: it was skipped since the time was over.
    """

    subject: str
    check: str
    verdict: Verdict
    measured: str
    remedy: str = ""
    values: Mapping[str, object] = field(default_factory=dict)
    out_of_time: bool = False

    @property
    def is_failure(self) -> bool:
        return self.verdict is Verdict.FAIL


def nearest(name: str, known: Iterable[str], count: int = 3) -> list[str]:
    """Return the known names most similar to an unknown one."""
    return get_close_matches(name, sorted(known), n=count, cutoff=0.6)


def listed(names: Iterable[str], most: int = 3) -> str:
    """Return names with commas; of many the first ones."""
    names = list(names)
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def milliseconds(seconds: float) -> str:
    """Return the text of a short time."""
    return f"{seconds * 1000:.1f} ms" if seconds < 0.1 else f"{seconds:.2f} s"
