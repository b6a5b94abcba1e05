"""Decodes a large JSON map in a process of its own.

A 4000 x 4000 grid is 54 MB of JSON. Decoding it holds Python's lock for half a second: no thread
could keep the screen alive meanwhile.
"""

import pickle
import subprocess
import sys

import msgspec

from fleet_tui.model.events import GridReceived
from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS, kind_of
from fleet_tui.robots.ros import operations
from fleet_tui.text.errors import WireError

LONGEST = 60.0


class _Task(msgspec.Struct):
    """The parameters of the process: one line of JSON before the frame."""

    profile: Profile
    feed: Feed


def decode_apart(profile: Profile, feed: Feed, payload: bytes) -> GridReceived:
    """Return the event of a text frame with a map. Blocks its thread, not the others.

    Raises WireError.
    """
    task = msgspec.json.encode(_Task(profile, feed)) + b"\n"
    command = [sys.executable, "-P", "-m", "fleet_tui.maps.map_process"]
    try:
        done = subprocess.run(
            command, input=task + payload, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=LONGEST
        )
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise WireError(f"map of {len(payload):,} bytes: {problem}") from None
    if done.returncode != 0:
        raise WireError(done.stdout.decode(errors="replace") or "decoding process ended early")
    # From our own child: that pipe has no other writer.
    grid = pickle.loads(done.stdout)
    assert isinstance(grid, GridReceived)
    return grid


def main() -> None:
    """Run the process: task and frame from standard input, the event to standard output."""
    task = msgspec.json.decode(sys.stdin.buffer.readline(), type=_Task)
    try:
        operation = operations.decode(sys.stdin.buffer.read())
        adapter = KINDS[kind_of(task.profile)].adapter(task.profile, Site())
        msg = operation.msg if isinstance(operation, operations.Publish) else None
        (event,) = adapter.read(task.feed, msg, 0.0)
    except WireError as problem:
        sys.stdout.write(str(problem))
        sys.exit(1)
    sys.stdout.buffer.write(pickle.dumps(event, protocol=pickle.HIGHEST_PROTOCOL))


if __name__ == "__main__":
    main()
