"""The names of one recording's files: `night.jsonl.gz`, `night.0001.jsonl.gz`, `night.0002.jsonl.gz`, ..."""

import re
from collections.abc import Iterator
from pathlib import Path

_SUFFIX = re.compile(r"(?:\.jsonl|\.json)?(?:\.gz)?$")


def _split(name: str) -> tuple[str, str]:
    found = _SUFFIX.search(name)
    cut = found.start() if found else len(name)
    return name[:cut], name[cut:]


def part_path(first: Path, number: int) -> Path:
    """Return the path of a part; 0 is the first."""
    stem, suffix = _split(first.name)
    return first.with_name(f"{stem}.{number:04}{suffix}") if number else first


def parts_beside(path: Path) -> Iterator[Path]:
    """Return every file that may be a part of the recording of `path`, in order of their numbers."""
    stem, suffix = _split(path.name)
    stem = re.sub(r"\.\d{4,9}$", "", stem)
    numbered = re.compile(re.escape(stem) + r"(?:\.(\d{4,9}))?" + re.escape(suffix))
    try:
        names = [found for one in path.parent.iterdir() if (found := numbered.fullmatch(one.name))]
    except OSError:
        names = []
    for found in sorted(names, key=lambda found: int(found[1] or 0)):
        yield path.with_name(found[0])
