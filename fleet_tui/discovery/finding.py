"""Findings of the doctor."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from enum import Enum


class Verdict(Enum):
    """The verdict of a finding; `SKIPPED` where an earlier step failed, or where nothing can be told."""

    OK = "ok"
    WARN = "warn"
    FAIL = "FAIL"
    SKIPPED = "skipped"


@dataclass(frozen=True, slots=True)
class Finding:
    """One line: of what, which check, what was measured, what to do about it, and the bare numbers.

    `out_of_time`: it was skipped since the time was over."""

    subject: str
    check: str
    verdict: Verdict
    measured: str
    remedy: str = ""
    values: Mapping[str, object] = field(default_factory=dict)
    out_of_time: bool = False

    @property
    def is_failure(self) -> bool:
        """Tell whether something is broken."""
        return self.verdict is Verdict.FAIL


def nearest(name: str, known: Iterable[str], count: int = 3) -> list[str]:
    """The known names that look most like one that is not known."""
    return get_close_matches(name, sorted(known), n=count, cutoff=0.6)


def listed(names: Iterable[str], most: int = 3) -> str:
    """Names with commas; of many the first ones."""
    names = list(names)
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def milliseconds(seconds: float) -> str:
    """A short time as a person reads it."""
    return f"{seconds * 1000:.1f} ms" if seconds < 0.1 else f"{seconds:.2f} s"
