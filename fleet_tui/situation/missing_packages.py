"""Message packages missing in a bridge's environment: the commonest mistake in setting rosbridge up."""

from collections.abc import Iterable
from dataclasses import dataclass

# Installed with every rosbridge.
ALWAYS_THERE = frozenset({"std_msgs", "geometry_msgs", "nav_msgs", "sensor_msgs", "diagnostic_msgs"})
FEWEST = 2  # minimum number of silent topics: one alone has many causes


@dataclass(frozen=True, slots=True)
class Listening:
    """A robot's topic that was subscribed long enough: its type, its number of publishers (None: unknown),
    and whether anything arrived."""

    robot: str
    type: str
    publishers: int | None
    received: bool


def unsourced_package(topics: Iterable[Listening]) -> str | None:
    """Return the package whose messages the bridge can't read, None if silence has another cause.

    Such a bridge accepts the subscriptions, and only its own log has the failed import. So every topic of the
    package stays silent, of robots with other active topics.
    """
    published = [topic for topic in topics if topic.publishers != 0]
    awake = {topic.robot for topic in published if topic.received}
    silent, received = list[str](), set[str]()
    for topic in published:
        package = topic.type.partition("/")[0]
        if topic.received:
            received.add(package)
        elif topic.robot in awake:
            silent.append(package)
    suspects = [package for package in silent if package not in received | ALWAYS_THERE]
    package = max(suspects, key=suspects.count, default="")
    return package if suspects.count(package) >= FEWEST else None
