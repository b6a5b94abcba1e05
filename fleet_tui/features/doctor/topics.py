"""Findings about each robot and its topics. Pure."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.schema import Config
from fleet_tui.features.doctor.causes import Cause
from fleet_tui.features.doctor.clocks import load_word
from fleet_tui.features.doctor.names import near_topic, robots_on
from fleet_tui.links.discovery.facts import LONG_ENOUGH, BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, listed, nearest
from fleet_tui.links.discovery.tools import LATCHED, LOOK_FOR_NODE, named
from fleet_tui.model.kind import CAMERA
from fleet_tui.model.navigation_events import OriginReported
from fleet_tui.robots.ros.names import is_hidden
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.situation.facts import ADRIFT

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import CameraImage


SMALL = 64
"""Pixels of the picture that is decoded to see that it can be."""
DRIVER = "check its camera driver"


def judged_camera(facts: TopicFacts) -> tuple[Verdict, str, str]:
    """Return verdict, measurement and remedy of a camera's topic, by its newest picture."""
    if not facts.count:
        if facts.waited < LONG_ENOUGH:
            return Verdict.SKIPPED, "not checked: out of time", "use a longer --timeout"
        complaint = f", rosbridge: {facts.complaint}" if facts.complaint else ""
        return Verdict.WARN, f"no picture on {facts.topic} in {facts.waited:.1f} s{complaint}", DRIVER
    # With numpy and Pillow, whose imports take longer than all other findings.
    from fleet_tui.model.set_up.streams import CameraImage

    image = facts.picture
    if not isinstance(image, CameraImage):
        return Verdict.WARN, f"no picture: unreadable: {facts.problem}", DRIVER
    if image.unshown:
        return Verdict.WARN, f"no picture: {image.unshown}", "publish JPEG or PNG of at most 4 MB"
    return _decoded(facts, image)


def _decoded(facts: TopicFacts, image: "CameraImage") -> tuple[Verdict, str, str]:
    from fleet_tui.ui.camera.decoding import decode

    found, kilobytes = decode(image.data, SMALL, SMALL), len(image.data) / 1000
    if found.pixels is None:
        return Verdict.WARN, f"no picture: {found.reason}", f"{DRIVER}, and the network between"
    width, height = found.size
    rate = "" if facts.rate is None else f", {facts.rate:.1f} Hz"
    return Verdict.OK, f"{width} x {height} px, {kilobytes:.0f} kB a picture{rate}", ""


SLOWEST_POSES = 5.0  # Hz; robots give about 10
OLDER = 0.5  # seconds by which the stamps of poses grow older while they are measured
UNSEEN = "existence unknown without rosapi"


def robot_findings(
    config: Config, robot: RobotEntry, facts: BridgeFacts, causes: Sequence[Cause]
) -> Iterator[Finding]:
    """Judge the robot itself, then each of its topics, without the consequences of the `causes`."""
    topics = facts.of(robot.name)
    first = _robot(config, robot, topics, facts, causes)
    yield first
    for one in topics:
        if one.wanted.robot != robot.name:  # several share it: it is listed with the first
            continue
        cause = next((cause for cause in causes if one.topic in cause.topics), None)
        if cause is not None:
            yield _finding(one, Verdict.SKIPPED, f"{cause.short}: see above")
        elif (
            first.is_failure
            and not one.wanted.is_shared
            and (not one.wanted.floor or not facts.knows(robot.name))
        ):
            yield _finding(one, Verdict.SKIPPED, f"{first.measured.partition(':')[0]}: see above")
        elif one.count or one.complaint or not facts.rosapi.lacks_action_of(one.topic):
            yield _topic(config, one, facts)


def _robot(
    config: Config, robot: RobotEntry, topics: list[TopicFacts], facts: BridgeFacts, causes: Sequence[Cause]
) -> Finding:
    everything = next((cause for cause in causes if all(one.topic in cause.topics for one in topics)), None)
    if topics and everything is not None:
        return Finding(robot.name, "robot", Verdict.SKIPPED, f"{everything.short}: see above")
    if not facts.knows(robot.name):
        known = {other.name for other in config.robots}
        others = nearest(robot.name, robots_on(facts.adapters[robot.name].names, facts.rosapi) - known)
        remedy = f"did you mean {listed(others)}? Correct the name" if others else "correct the name"
        place, table = f"robots[{config.robots.index(robot)}].name", facts.table(robot.name)
        return Finding(
            robot.name,
            "robot",
            Verdict.FAIL,
            f"not on this bridge: none of its {len(topics)} topics found",
            f"{remedy} in {place} ([{table}.topics] if all names differ), or switch it on",
        )
    # Latched messages describe the past.
    live = [one for one in topics if not one.wanted.floor and not one.wanted.latched]
    live.sort(key=lambda one: one.wanted.silent)
    received, asked = [one for one in live if one.count], [one for one in live if one.subscribed]
    explained = [cause for one in asked for cause in causes if one.topic in cause.topics]
    if not received and explained and len(explained) >= len(asked):
        return Finding(robot.name, "robot", Verdict.SKIPPED, f"{explained[0].short}: see above")
    if not received and any(one.is_silent for one in asked):
        return _silent(robot, asked, facts)
    measured = f"messages on {len(received)} of {len(live)} live topics"
    return Finding(robot.name, "robot", Verdict.OK if received else Verdict.SKIPPED, measured)


def _silent(robot: RobotEntry, asked: list[TopicFacts], facts: BridgeFacts) -> Finding:
    nodes = sorted({node for one in asked for node in facts.rosapi.publishers.get(one.topic, ())})
    by = f", published by {listed(nodes)}" if nodes else ""
    waited = max(one.waited for one in asked)
    look = named(LOOK_FOR_NODE, facts.rosapi.ros, nodes[0] if nodes else "")
    return Finding(
        robot.name,
        "robot",
        Verdict.FAIL,
        f"silent: no messages on {listed([one.topic for one in asked])} in {waited:.1f} s{by}",
        f"check power, network and its nodes ({look})"
        + f" ({UNSEEN}: check its name)" * bool(facts.rosapi.problem),
        {"nodes": nodes},
    )


def _finding(
    facts: TopicFacts, verdict: Verdict, measured: str, remedy: str = "", **values: object
) -> Finding:
    wanted = facts.wanted
    check = f"{wanted.key} of {wanted.floor}" if wanted.floor else wanted.key
    # The only skipped check with a remedy is one for lack of time.
    out_of_time = verdict is Verdict.SKIPPED and bool(remedy)
    return Finding(
        wanted.robot, check, verdict, measured, remedy, {"topic": facts.topic, **values}, out_of_time
    )


def _topic(config: Config, facts: TopicFacts, bridge: BridgeFacts) -> Finding:
    rosapi = bridge.rosapi
    if not rosapi.problem and not facts.count and not rosapi.has(facts.topic):
        return _missing(config, facts, bridge)
    there, expected = rosapi.topics.get(facts.topic, ""), facts.wanted.type
    if there and not same_type(there, expected):
        return _wrong_type(config, facts, there, bridge)
    if facts.wanted.large and not facts.subscribed:
        return _finding(facts, Verdict.OK, f"{expected}, not subscribed: one source is enough", type=there)
    if bridge.lost and not facts.count:
        return _finding(facts, Verdict.SKIPPED, f"the link was lost: {bridge.lost}")
    return _received(config, facts, bridge)


def _missing(config: Config, facts: TopicFacts, bridge: BridgeFacts) -> Finding:
    wanted, key = facts.wanted, facts.wanted.key
    remedy = near_topic(config, facts, bridge)
    floor = next((floor for floor in config.floors if floor.name == wanted.floor), None)
    measured = f"{facts.topic} is not on the bridge"
    if facts.topic in bridge.rosapi.topics:
        measured = f"{facts.topic} has subscribers but no publisher"
    if key == "pose" and (transforms := _placing(wanted.robot, bridge)):
        return _finding(facts, Verdict.OK, f"{measured}, not needed: {transforms} has its place")
    if key == "map" and floor is not None and floor.map:
        return _finding(facts, Verdict.OK, f"{measured}, not needed: {floor.name} has a map file")
    if key == "map":
        remedy = remedy or f"publish it, or set floors.map of {wanted.floor}: until then the floor is blank"
        return _finding(facts, Verdict.WARN, measured, remedy)
    if key == "map_metadata" and (floor is None or not floor.map or floor.map.endswith((".yaml", ".yml"))):
        return _finding(facts, Verdict.WARN, measured, remedy)
    names = bridge.adapters[wanted.robot].names
    heard = {one.wanted.key for one in bridge.of(wanted.robot) if one.count}
    placing = "pose" if names.topic("pose", wanted.robot) else "tf"
    if key == placing and wanted.silent and heard and "tf" not in heard:  # transforms are judged themselves
        if remedy:
            check = f"{remedy}; else {ADRIFT.action.lower()}"
        else:
            check = f"{ADRIFT.action}; if it runs, correct [{names.table}.topics] pose"
        return _finding(facts, Verdict.FAIL, f"{ADRIFT.word}: {measured}", check)
    if wanted.silent and not remedy and key not in names.profile.topics:
        return _finding(facts, Verdict.SKIPPED, f"{measured}: not needed")
    if wanted.silent:
        none = f'start the node that publishes it, or set [{names.table}.topics] {key} = "" if not used'
        return _finding(facts, Verdict.WARN, measured, remedy or none)
    start = f"start the node that publishes it, or correct [{names.table}.topics] {key}"
    return _finding(facts, Verdict.FAIL, measured, remedy or start)


def _placing(robot: str, bridge: BridgeFacts) -> str:
    """Return the topic of transforms that place a robot on its map, empty if none do."""
    placed = (one for one in bridge.of(robot) if isinstance(one.events.get(robot), OriginReported))
    return next((one.topic for one in placed), "")


def _wrong_type(config: Config, facts: TopicFacts, there: str, bridge: BridgeFacts) -> Finding:
    key, expected = facts.wanted.key, facts.wanted.type
    other = near_topic(config, facts, bridge)
    table = bridge.table(facts.wanted.robot)
    same = f'if the fields match, set [{table}.types] {key} = "{there}"'
    measured = f"{facts.topic} has type {there}, not {expected}: not subscribed"
    remedy = f"{same}; else {other or f'correct [{table}.topics] {key}'}"
    return _finding(facts, Verdict.FAIL, measured, remedy, type=there, expected_type=expected)


def _received(config: Config, facts: TopicFacts, bridge: BridgeFacts) -> Finding:
    rosapi = bridge.rosapi
    nodes = rosapi.publishers.get(facts.topic)
    values = {
        "type": rosapi.topics.get(facts.topic) or None,
        "expected_type": facts.wanted.type,
        "publishers": None if nodes is None else len(nodes),
        "nodes": nodes,
        "messages": facts.count,
        "unreadable": facts.faults,
        "rate_hz": None if facts.rate is None else round(facts.rate, 2),
        "age_s": None if facts.age is None else round(facts.age, 2),
        "first_after_s": None if facts.first_after is None else round(facts.first_after, 3),
    }
    verdict, measured, remedy = _verdict(config, facts, bridge)
    if rosapi.problem and verdict in (Verdict.WARN, Verdict.FAIL) and not facts.count:
        table = bridge.table(facts.wanted.robot)
        remedy += f" ({UNSEEN}: check [{table}.topics] {facts.wanted.key} and its type)"
    measured = f"{measured}, {facts.wanted.type}" if verdict is Verdict.OK else measured
    by = f", by {listed(nodes)}" if nodes and verdict is not Verdict.SKIPPED else ""
    if verdict is Verdict.OK and nodes and len(nodes) > 1 and not facts.wanted.is_shared:
        verdict, remedy = Verdict.WARN, f"stop all but one of the {len(nodes)} publishing nodes"
    return _finding(facts, verdict, f"{measured}{by}", remedy, **values)


def _verdict(config: Config, facts: TopicFacts, bridge: BridgeFacts) -> tuple[Verdict, str, str]:
    if facts.fragmented or (facts.retried and facts.count):
        return _received_on_retry(facts, bridge.rosapi)
    if facts.wanted.stream_key == CAMERA:
        return judged_camera(facts)
    return _judged(config, facts, bridge) if facts.count else _nothing_received(facts, bridge.rosapi)


def _received_on_retry(facts: TopicFacts, rosapi: RosapiFacts) -> tuple[Verdict, str, str]:
    """Judge a topic that arrived only with default options, or fragmented. What is sent only on a change must
    be latched: that of a floor."""
    if facts.fragmented:
        binary = "never as cbor, " if facts.wanted.large else ""
        return (
            Verdict.WARN,
            f"received {binary}only as JSON fragments ({facts.fragmented / 1e6:.1f} MB): larger than the"
            " bridge's max_message_size",
            "start rosbridge with a larger max_message_size (10 MB in its launch file, 1 MB with ros2 run)",
        )
    if not facts.wanted.floor:
        return Verdict.OK, "received without quality of service: its publisher is volatile", ""
    asked = "cbor, or quality of service" if facts.wanted.large else "quality of service"
    return (
        Verdict.WARN,
        f"received only without {asked}: its publisher is volatile",
        f"publish it {named(LATCHED, rosapi.ros)}, for late subscribers",
    )


def _nothing_received(facts: TopicFacts, rosapi: RosapiFacts) -> tuple[Verdict, str, str]:
    key = facts.wanted.key
    had_time = facts.waited >= LONG_ENOUGH and not facts.complaint
    if had_time and rosapi.lists_action_of(facts.topic):
        return Verdict.OK, "action server available; no messages before the first goal", ""
    if had_time and is_hidden(facts.topic):
        return Verdict.SKIPPED, "action topic: not listed, no messages before the first goal", ""
    if had_time and facts.wanted.silent:
        return Verdict.OK, f"no messages in {facts.waited:.1f} s: sent only on change", ""
    if not facts.is_silent:
        return Verdict.SKIPPED, "not checked: out of time", "use a longer --timeout"
    nodes = rosapi.publishers.get(facts.topic)
    nothing = f"no messages on {facts.topic} in {facts.waited:.1f} s"
    if facts.complaint:
        nothing += f", rosbridge: {facts.complaint}"
    if not facts.wanted.latched:
        look = named(LOOK_FOR_NODE, rosapi.ros, nodes[0] if nodes else "")
        return Verdict.FAIL, nothing, f"check that its publisher runs ({look})"
    if facts.held_by and nodes:
        return (
            Verdict.FAIL,
            f"{nothing}: another client subscribed before the publisher was found, so no client"
            " gets the last value; the publisher is fine",
            "restart rosbridge, or disconnect all its clients for a second",
        )
    optional = key in ("map", "map_metadata") and nodes is None
    late = f"publish it {named(LATCHED, rosapi.ros)}, for late subscribers"
    return (Verdict.WARN if optional else Verdict.FAIL), nothing, late


def _judged(config: Config, facts: TopicFacts, bridge: BridgeFacts) -> tuple[Verdict, str, str]:
    fields = f"correct [{bridge.table(facts.wanted.robot)}.fields] or the publishing node"
    if facts.event is None and facts.faults:
        return Verdict.FAIL, f"{facts.topic} unreadable: {facts.problem}", fields
    if facts.faults:
        return Verdict.FAIL, f"{facts.faults} parts unreadable: {facts.problem}", fields
    if facts.wanted.latched:
        return Verdict.OK, f"received {facts.first_after or 0.0:.2f} s after a late subscription", ""
    age = f"last {facts.age or 0.0:.1f} s ago"
    measured = age if facts.rate is None else f"{facts.rate:.1f} Hz, {age}"
    if facts.wanted.fast and (facts.rate or 0.0) < SLOWEST_POSES:
        if word := load_word(bridge):
            return Verdict.SKIPPED, f"{measured}: {word}, see its load above", ""
        slow = f"{measured}: poses should arrive at about 10 Hz"
        return Verdict.WARN, slow, "check the load of the network and the robot's computer"
    if facts.late is not None and facts.late >= OLDER and not load_word(bridge):
        older = f"{measured}: its stamps were {facts.late:.1f} s older at the end"
        return Verdict.WARN, older, "check its localisation: it repeats or delays its poses"
    adapter, usual = bridge.adapters[facts.wanted.robot], config.alarms.offline_after
    silence = adapter.kind.silence_of(facts.wanted.key, usual)
    if facts.rate is not None and 1 / facts.rate > silence:
        if silence == usual:
            return Verdict.WARN, f"{measured}: slower than offline_after", "raise alarms.offline_after"
        key = f"{adapter.names.table}.silence.{facts.wanted.key}"
        return Verdict.WARN, f"{measured}: counts as old after {silence:g} s", f"raise {key}"
    return Verdict.OK, measured, ""
