"""P28: a change at one console of the desk -> seen at every other. Run: python -m tests.bench.bench_desk"""

import tempfile
import time
from pathlib import Path

from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.desk.events import EdgeClosed, RobotClaimed
from tests.bench.rows import Row, row
from tests.support.shared_desk import DeskConsole, at_desk

TIMES = 20


def slowest(consoles: int) -> tuple[float, float]:
    """Return the longest milliseconds until all see a claim, and a closed edge, on a local disk."""
    claims, edges = list[float](), list[float]()
    names = [f"user_{n}" for n in range(consoles)]
    with tempfile.TemporaryDirectory() as folder, at_desk(Path(folder), *names) as them:
        for turn in range(TIMES):
            claims.append(_claimed(them, f"robot_{turn}"))
            edges.append(_closed(them, str(turn)))
    return 1000 * max(claims), 1000 * max(edges)


def _claimed(consoles: list[DeskConsole], robot: str) -> float:
    began = time.monotonic()
    consoles[0].post(RobotClaimed(robot))
    for one in consoles:
        one.becomes(lambda state: state.desk.holders(robot))
    return time.monotonic() - began


def _closed(consoles: list[DeskConsole], vertex: str) -> float:
    began, ends = time.monotonic(), ends_of("floor_0", vertex, "x")
    consoles[0].post(EdgeClosed(ends, 1.0))
    for one in consoles:
        one.becomes(lambda state: ends in [edge.ends for edge in state.desk.closed])
    return time.monotonic() - began


def main() -> list[Row]:
    (claim, edge), (claim_of_many, edge_of_many) = slowest(2), slowest(20)
    return [
        row("P28", "claim -> seen by 20 consoles, slowest", claim_of_many, "ms", 1000, claim, "2 consoles"),
        row("P28", "closed edge -> seen by 20, slowest", edge_of_many, "ms", 1000, edge, "2 consoles"),
    ]


if __name__ == "__main__":
    main()
