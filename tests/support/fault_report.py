"""What the tests measure, for the table in docs/faults.md, where FLEET_TUI_FAULTS names a file for it."""

import json
import os
import sys
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

HEAD = """# Faults

Each line is a test in `tests/faults` that drives the real program against the real loopback server, most of
them through a proxy that makes the fault. `make faults` runs them and writes this table: the times are those
of its last run, in seconds from the fault until the state says so, and from its end until everything is as
before. `make test` runs the same with shorter delays.

In none of them is an order, an alarm or the terminal lost, and after each of them a check looks at that
(`tests/support/invariants.py`, and `terminal_session.py` where the whole program runs):

- Each command has exactly one end, or is open and says so as `outcome unknown` or `no answer`; it left
  once, or not at all if it was not sent; every step of it is a line of the audit log, and every line is
  whole. Most faults meet a command that is under way.
- Each alarm that was there is there, or the log says that it was cleared. Most faults meet one.
- The program ends within its time when it is told to, and its terminal is as it was.

What cannot be: after SIGKILL nobody gives the terminal back (`reset` does), and the log ends without
`console closed`. Who hung up has no terminal any more. Where no file can grow, or there is no folder, the
log is lost: the screen says so, and stderr at the end how much. Alarms are made of what robots say: the
next console raises them again.

| fault | how it is made | what the operator sees | noticed after | healed after |
|---|---|---|---|---|
"""


@dataclass(frozen=True)
class Row:
    """A fault. Times in seconds; None where there is nothing to notice or to heal."""

    fault: str
    made_by: str
    seen: str
    noticed: float | None
    healed: float | None


def report(fault: str, made_by: str, seen: str, noticed: float | None, healed: float | None) -> None:
    """Keep what was measured, if anybody asks for it."""
    if path := os.environ.get("FLEET_TUI_FAULTS"):
        with Path(path).open("a") as rows:
            rows.write(json.dumps(asdict(Row(fault, made_by, seen, noticed, healed))) + "\n")


def table(lines: Iterable[str]) -> str:
    """The document."""
    rows = sorted(
        {row["fault"]: row for row in map(json.loads, lines)}.values(), key=lambda row: row["fault"]
    )
    return HEAD + "".join(
        f"| {row['fault']} | {row['made_by']} | {row['seen']} | {_seconds(row['noticed'])}"
        f" | {_seconds(row['healed'])} |\n"
        for row in rows
    )


def _seconds(value: float | None) -> str:
    return "-" if value is None else f"{value:.1f} s"


if __name__ == "__main__":
    text = table(Path(sys.argv[1]).read_text().splitlines())
    Path(sys.argv[2]).write_text(text)
    print(text)
