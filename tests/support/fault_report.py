"""The measurements of tests/faults, kept in the file FLEET_TUI_FAULTS, and the table in docs/faults.md."""

import json
import os
import sys
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

HEAD = """# Faults

For operators and reliability engineers: every fault that is tested, what the console shows, and how soon
it notices and recovers.

Each line is a test in `tests/faults` that drives the real program against the real loopback server,
mostly through a proxy that injects the fault. `make faults` runs the tests and writes this table. The
times are those of its last run, in seconds: from the fault until the state shows it, and from its end
until everything is as before. `make test` runs the same tests with shorter delays.

None of these faults loses an order, an alarm or the terminal. After each fault a check verifies this
(`tests/support/invariants.py`, and `terminal_session.py` if the whole program runs):

- Each command has exactly one end, or is open and marked `outcome unknown` or `no answer`. It was sent
  once, or not at all if it is `not sent`. Every step is a line of the audit log, and every line is
  whole. Most tests have a command in progress.
- Each earlier alarm is still there, or the log says that it was cleared. Most tests have one.
- The program exits in time when told to, and leaves its terminal as it was.

Some things are impossible: after SIGKILL the terminal is not restored (use `reset`), and the log ends
without `console closed`. After a hang-up there is no terminal to restore. If no file can grow, or the
folder is missing, the log is lost; the screen says so, and stderr reports the extent at the end. Alarms
are derived from the robots' reports: the next console raises them again.

| fault | how it is made | what the operator sees | noticed after | healed after |
|---|---|---|---|---|
"""


@dataclass(frozen=True)
class Row:
    """A fault. Times in seconds; None if there is nothing to notice or to recover from."""

    fault: str
    made_by: str
    seen: str
    noticed: float | None
    healed: float | None


def report(fault: str, made_by: str, seen: str, noticed: float | None, healed: float | None) -> None:
    """Add a row to the file FLEET_TUI_FAULTS, if it is set."""
    if path := os.environ.get("FLEET_TUI_FAULTS"):
        with Path(path).open("a") as rows:
            rows.write(json.dumps(asdict(Row(fault, made_by, seen, noticed, healed))) + "\n")


def table(lines: Iterable[str]) -> str:
    """Return the text of docs/faults.md."""
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
