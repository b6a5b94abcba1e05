"""Findings of a broker and its vehicles: session, rights, versions, ages, clocks."""

import json
from collections.abc import Iterator

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config, link_key
from fleet_tui.features.doctor.broker_facts import BrokerFacts, VehicleFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, listed, milliseconds
from fleet_tui.links.discovery.vehicles import STATE_EVERY
from fleet_tui.robots.vda5050.orders import TAKES_NO_ORDERS, major_of
from fleet_tui.robots.vda5050.topics import OF_MASTERS
from fleet_tui.situation.facts import NEVER_SEEN

CLOCK_OFF = 2.0
"""Seconds by which a vehicle's clock may differ."""
RETAIN = "let its software retain each connection message: the broker's last word would be wrong"


def broker_findings(config: Config, facts: BrokerFacts) -> Iterator[Finding]:
    key = link_key(facts.name)
    if facts.reason:
        remedy = f"correct url, user_file and password_file in {key}"
        yield Finding(facts.name, "mqtt", Verdict.FAIL, facts.reason, remedy)
        return
    trips = facts.round_trips
    trip = f", reply in {milliseconds(min(trips))}" if trips else ""
    yield Finding(facts.name, "mqtt", Verdict.OK, f"session open in {milliseconds(facts.opened_in)}{trip}")
    yield from _rights(config, facts)
    robots = [robot for robot in config.robots if robot.name in facts.robots]
    if facts.strangers:
        names = listed(sorted("/".join(one) for one in facts.strangers))
        measured = f"{len(facts.strangers)} on the broker not configured: {names}"
        remedy = "add them with manufacturer and serial, or ignore this"
        yield Finding(facts.name, "vehicles", Verdict.OK, measured, remedy)
    for robot in robots:
        yield from _vehicle(config, robot, facts.robots[robot.name], facts.heard_for)


def _rights(config: Config, facts: BrokerFacts) -> Iterator[Finding]:
    """Return the finding of the subscriptions: those to the messages of masters are only a help."""
    feeds = {feed.address: feed for feed in feeds_of(config, adapters_of(config), facts.name)}
    refused = [
        feeds[pattern] for pattern, granted in facts.granted.items() if not granted and pattern in feeds
    ]
    needed = [feed.address for feed in refused if feed.key not in OF_MASTERS]
    if needed:
        measured = f"broker refuses {len(needed)}: {listed(needed)}"
        yield Finding(facts.name, "read access", Verdict.FAIL, measured, "grant the user read access to them")
    elif refused:
        measured = f"broker refuses {listed([feed.address for feed in refused])}"
        remedy = "grant read access, or other master controls go unseen"
        yield Finding(facts.name, "read access", Verdict.WARN, measured, remedy)
    else:
        yield Finding(facts.name, "read access", Verdict.OK, f"{len(facts.granted)} subscriptions granted")


def _vehicle(config: Config, robot: RobotEntry, facts: VehicleFacts, seconds: float) -> Iterator[Finding]:
    known = facts.vehicle or facts.connection
    if known is None:
        remedy = "start it, or correct manufacturer and serial of the robot"
        yield Finding(
            robot.name, "connection", Verdict.FAIL, f"{NEVER_SEEN.word}: no connection message", remedy
        )
        return
    yield _connection(robot.name, facts)
    yield _version(config, robot, known.version)
    yield _state(robot.name, facts, seconds)
    poses = facts.arrivals.get("visualization", [])
    if len(poses) > 1:
        rate = (len(poses) - 1) / max(1e-6, poses[-1] - poses[0])
        yield Finding(
            robot.name, "visualization", Verdict.OK, f"{rate:.1f} Hz", values={"hz": round(rate, 2)}
        )
    yield from _clock(robot.name, facts)
    yield from _floor(config, robot, facts)
    if facts.problem:
        yield Finding(robot.name, "messages", Verdict.WARN, facts.problem, "tell its manufacturer")


def _connection(name: str, facts: VehicleFacts) -> Finding:
    known = facts.connection
    if known is None or not facts.is_kept:
        return Finding(name, "connection", Verdict.WARN, "not retained by the broker", RETAIN)
    if not known.is_gone:
        return Finding(name, "connection", Verdict.OK, known.text)
    if "state" in facts.arrivals:
        measured = f"{known.text} is retained, and the vehicle reports"
        return Finding(name, "connection", Verdict.WARN, measured, RETAIN)
    return Finding(name, "connection", Verdict.WARN, known.text, "switch it on, or check its network")


def _version(config: Config, robot: RobotEntry, version: str) -> Finding:
    role = config.bridges[robot.link].role
    if (major_of(version) or 0) >= TAKES_NO_ORDERS and role == "master":
        measured = f"VDA 5050 {version}: read and paused, but no orders are sent"
        return Finding(
            robot.name, "version", Verdict.WARN, measured, f'{link_key(robot.link)}.role = "pause"'
        )
    return Finding(robot.name, "version", Verdict.OK, f"VDA 5050 {version or 'unknown'}")


def _state(name: str, facts: VehicleFacts, seconds: float) -> Finding:
    came = facts.arrivals.get("state", [])
    if not came:
        measured = f"none in {seconds:.0f} s"
        remedy = f"wait: it is sent at least every {STATE_EVERY:.0f} s; then check the right to read it"
        return Finding(name, "state", Verdict.WARN, measured, remedy)
    return Finding(name, "state", Verdict.OK, f"{len(came)} in {seconds:.1f} s", values={"count": len(came)})


def _clock(name: str, facts: VehicleFacts) -> Iterator[Finding]:
    if not facts.lags:
        return
    lag = min(facts.lags, key=abs)
    values = {"seconds": round(lag, 3)}
    if abs(lag) <= CLOCK_OFF:
        yield Finding(name, "clock", Verdict.OK, f"within {abs(lag):.1f} s of ours", values=values)
        return
    measured = f"{abs(lag):.0f} s {'behind' if lag > 0 else 'ahead of'} ours"
    yield Finding(
        name, "clock", Verdict.WARN, measured, "set the clocks by NTP: kept messages are aged by them", values
    )


def _floor(config: Config, robot: RobotEntry, facts: VehicleFacts) -> Iterator[Finding]:
    if facts.pose is None:
        return
    frames = {floor.frame: floor.name for floor in config.floors}
    frame = facts.pose.frame_id.lstrip("/")
    if frame in frames:
        yield Finding(robot.name, "floor", Verdict.OK, f"{frames[frame]} (mapId {frame})")
        return
    if not frame:
        remedy = "give its positions a mapId at the vehicle, or in its map: without one they are of no floor"
        yield Finding(robot.name, "floor", Verdict.FAIL, "no mapId: drawn on none", remedy)
        return
    remedy = f"set frame_id = {json.dumps(frame)} in one of [[floors]]"
    yield Finding(robot.name, "floor", Verdict.FAIL, f"mapId {frame!r} is no floor: drawn on none", remedy)
