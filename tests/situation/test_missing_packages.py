"""Which silence means that a bridge was started without a package of messages."""

import pytest

from fleet_tui.situation.missing_packages import Listening, unsourced_package

POSE = Listening("r1", "geometry_msgs/PoseStamped", 1, True)
QUEUE = Listening("r1", "OH_ressources/ActionQueue", 1, False)
GRAPH = Listening("r1", "OH_ressources/Graph", 1, False)
HEARD = Listening("r2", "OH_ressources/ActionQueue", 1, True)
BATTERY, CARGO = Listening("r1", "std_msgs/Float32", 1, False), Listening("r1", "std_msgs/Bool", 1, False)
OFF = [Listening("r9", "geometry_msgs/PoseStamped", 1, False), Listening("r9", "x_msgs/State", 1, False)]


@pytest.mark.parametrize(
    ("topics", "package"),
    [
        ([POSE, QUEUE, GRAPH], "OH_ressources"),
        ([POSE, QUEUE, GRAPH, BATTERY], "OH_ressources"),  # a fault of its own beside it
        ([POSE, QUEUE, GRAPH, *OFF], "OH_ressources"),  # a robot that is off beside it
        ([POSE, QUEUE], None),  # one topic alone has many causes
        ([POSE, QUEUE, GRAPH, HEARD], None),  # the bridge knows the package
        ([POSE, BATTERY, CARGO], None),  # wherever rosbridge is, this package is too
        ([QUEUE, GRAPH], None),  # the robot is silent altogether
        ([POSE, QUEUE, Listening("r1", "OH_ressources/Graph", 0, False)], None),  # nobody publishes it
        ([POSE, QUEUE, Listening("r1", "OH_ressources/msg/Graph", None, False)], "OH_ressources"),
        ([], None),
    ],
)
def test_a_package_is_named_where_only_it_can_be_the_cause(
    topics: list[Listening], package: str | None
) -> None:
    assert unsourced_package(topics) == package
