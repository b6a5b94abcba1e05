"""Messages that a bridge was started without: the commonest mistake in setting rosbridge up."""

from collections.abc import Iterable
from dataclasses import dataclass

# Wherever rosbridge is installed these are too.
ALWAYS_THERE = frozenset({"std_msgs", "geometry_msgs", "nav_msgs", "sensor_msgs", "diagnostic_msgs"})
FEWEST = 2  # silent topics: one alone has many causes


@dataclass(frozen=True, slots=True)
class Listening:
    """A robot's topic that is listened to long enough: its type, how many nodes publish it (None: not
    known), and whether anything came."""

    robot: str
    type: str
    publishers: int | None
    heard: bool


def unsourced_package(topics: Iterable[Listening]) -> str | None:
    """Name the package whose messages the bridge can't read, None where silence has another cause.

    Such a bridge takes the subscriptions, and says only in its own log that it can't import the package. So
    every topic of it stays silent, of robots of which other topics come.
    """
    published = [topic for topic in topics if topic.publishers != 0]
    awake = {topic.robot for topic in published if topic.heard}
    silent, heard = list[str](), set[str]()
    for topic in published:
        package = topic.type.partition("/")[0]
        if topic.heard:
            heard.add(package)
        elif topic.robot in awake:
            silent.append(package)
    suspects = [package for package in silent if package not in heard | ALWAYS_THERE]
    package = max(suspects, key=suspects.count, default="")
    return package if suspects.count(package) >= FEWEST else None
