"""The rank of a line for the text typed to find it."""

import re

_WORD = re.compile(r"[^\s:;,()<>]+")


def rank(typed: str, line: str, name: str = "") -> int | None:
    """Return how well a line fits, 0 best: it has this `name`, begins so, has words that are these or begin
    so, contains them; else None."""
    typed, line = typed.strip().lower(), line.lower()
    wanted, words = typed.split(), _WORD.findall(line)
    tests = (
        typed == name.lower(),
        line.startswith(typed),
        all(word in words for word in wanted),
        all(any(word.startswith(begin) for word in words) for begin in wanted),
        all(part in line for part in wanted),
    )
    return tests.index(True) if any(tests) else None
