"""The doctor command: every bridge one by one, then floors, clocks and the terminal."""

import asyncio
import json
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import assert_never

from msgspec import structs

from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.schema import Config
from fleet_tui.features.doctor.broker_facts import BrokerFacts, facts_of_broker
from fleet_tui.features.doctor.brokers import broker_findings
from fleet_tui.features.doctor.causes import Cause, causes_of, namespace_finding, rosapi_finding
from fleet_tui.features.doctor.clocks import clock_findings, load_finding, round_trip_finding
from fleet_tui.features.doctor.floors import FloorFiles, floor_findings, place_finding, placed_grid
from fleet_tui.features.doctor.gather import gather
from fleet_tui.features.doctor.names import near_service, spelling_finding
from fleet_tui.features.doctor.probing import bridge_probes, probe_findings
from fleet_tui.features.doctor.render import as_values, line, summary
from fleet_tui.features.doctor.surveys import FloorSurvey, surveys_of
from fleet_tui.features.doctor.terminal import terminal_findings
from fleet_tui.features.doctor.topics import robot_findings
from fleet_tui.links.discovery.approach import Approach
from fleet_tui.links.discovery.facts import BridgeFacts, TopicFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.maps.floor_files import load_floors
from fleet_tui.model.events import FloorGraphLoaded, FloorMapLoaded, PoseReported
from fleet_tui.model.fleets.events import MemberReported, StatusReported, TaskReported
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.navigation_events import FloorReported, LocalisationReported
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import ConfigError, did_you_mean
from fleet_tui.text.units import age, counted


def service_findings(robot: str, facts: BridgeFacts, causes: Sequence[Cause]) -> Iterator[Finding]:
    """Return one finding for each service, one for all if they can't be looked up."""
    if facts.rosapi.problem:
        yield Finding(robot, "services", Verdict.SKIPPED, "unknown without rosapi")
    elif not facts.knows(robot):
        yield Finding(robot, "services", Verdict.SKIPPED, "not on this bridge: see above")
    else:
        called = list(facts.adapters[robot].services(robot))
        for key, service, expected in called:
            cause = next((cause for cause in causes if service in cause.services), None)
            if cause is None:
                yield _service(robot, key, service, expected, facts)
            else:
                values = {"service": service, "node": facts.rosapi.owners.get(service)}
                folded = f"{cause.short}: see above"
                yield Finding(robot, f"service {key}", Verdict.SKIPPED, folded, values=values)


def _service(robot: str, key: str, service: str, expected: str, facts: BridgeFacts) -> Finding:
    rosapi, adapter = facts.rosapi, facts.adapters[robot]
    table = adapter.names.table
    there, node = rosapi.services.get(service), rosapi.owners.get(service)
    values = {"service": service, "type": there or None, "expected_type": expected, "node": node or None}

    def finding(verdict: Verdict, measured: str, remedy: str = "", out_of_time: bool = False) -> Finding:
        return Finding(robot, f"service {key}", verdict, measured, remedy, values, out_of_time)

    if service not in rosapi.services:
        start = f"start the node that provides it, or correct [{table}.services] {key}"
        remedy = near_service(adapter, robot, key, service, expected, rosapi) or start
        return finding(Verdict.FAIL, f"{service} is not on the bridge", remedy)
    if there is None:
        return finding(Verdict.SKIPPED, "type not checked: out of time", "use a longer --timeout", True)
    by = f", by {node}" if node else ""
    if there and not same_type(there, expected):
        return finding(
            Verdict.FAIL,
            f"{service}{by} has type {there}, not {expected}",
            f'if the fields match, set [{table}.service_types] {key} = "{there}"; else correct'
            f" [{table}.services] {key}",
        )
    return finding(Verdict.OK, f"{service}, {there or 'type unknown'}{by}")


def member_findings(robot: str, facts: BridgeFacts, offline_after: float) -> Iterator[Finding]:
    """Judge the age of a robot's location by the clock of its driver, and the issues of its adapter."""
    for one in facts.of(robot):
        event = one.events.get(robot)
        if isinstance(event, MemberReported):
            yield _location(robot, event, one.lags.get(robot), one.lag, offline_after)
        elif isinstance(event, StatusReported) and event.issues:
            remedy = "see the log of its fleet adapter"
            yield Finding(robot, "issues", Verdict.WARN, "; ".join(event.issues[:3]), remedy)
        elif isinstance(event, TaskReported):
            state = event.task.state.value if event.task.state else event.task.word
            told = f"{counted(one.count, 'message')} of tasks, the last of {event.task.id}: {state}"
            yield Finding(robot, "task", Verdict.OK, told)


def _location(
    robot: str, event: MemberReported, lag: float | None, least: float | None, offline_after: float
) -> Finding:
    if event.stamp is None or lag is None or least is None:
        measured = "its driver gives no time: the age of its location is unknown"
        return Finding(robot, "location", Verdict.WARN, measured, "set location.t in its fleet adapter")
    # The robot with the newest stamp has the clock of all.
    old = lag - least
    if old > offline_after:
        measured = f"{age(old)} old, while its fleet adapter goes on"
        return Finding(
            robot, "location", Verdict.FAIL, measured, "check the robot and the driver of its fleet"
        )
    return Finding(robot, "location", Verdict.OK, f"{age(old)} old, on {event.floor}")


FINE = 0
BROKEN = 1
NO_LINK = 3
SPARE = 1.5  # seconds reserved for the steps after the bridges, at most a quarter of all

Take = Callable[[Finding], None]


async def _walk(config: Config, name: str, until: float, take: Take) -> BridgeFacts | None:
    """Connect to one bridge, outside in; None if it can't be reached."""
    bridge = config.bridge(name)
    wire = BridgeConnection(bridge)
    approach = Approach(name, bridge, wire, "" if config.path != Path() else "the address")
    try:
        is_up = True
        async with asyncio.timeout_at(asyncio.get_running_loop().time() + max(0.1, until - time.monotonic())):
            async for finding in approach.walk():
                take(finding)
                is_up = is_up and finding.verdict is Verdict.OK
        return await gather(config, name, wire, until) if is_up else None
    except TimeoutError:
        take(Finding(name, "time", Verdict.FAIL, "out of time before it responded", "use a longer --timeout"))
        return None
    finally:
        wire.close()


def only(config: Config, robot: str) -> Config:
    """Return the configuration of one robot and its floors. Raises ConfigError for an unknown name."""
    known = {entry.name: entry for entry in config.robots}
    if robot not in known:
        raise ConfigError([f"--robot {robot}: unknown robot{did_you_mean(robot, known)}"])
    floors = [floor for floor in config.floors if floor.name in config.floors_of(known[robot])]
    return structs.replace(config, robots=[known[robot]], floors=floors)


def bridge_findings(config: Config, facts: BridgeFacts) -> Iterator[Finding]:
    yield round_trip_finding(facts)
    yield rosapi_finding(facts)
    yield load_finding(facts)
    if facts.lost:
        remedy = "see the rosbridge log; the results below use earlier messages"
        yield Finding(facts.name, "link", Verdict.FAIL, f"lost while measuring: {facts.lost}", remedy)
    yield from bridge_probes(facts)
    yield from filter(None, (spelling_finding(config, facts), namespace_finding(facts)))
    causes = causes_of(config, facts)
    yield from (cause.finding for cause in causes)
    robots = [robot for robot in config.robots if facts.of(robot.name)]
    for robot in robots:
        yield from robot_findings(config, robot, facts, causes)
    for robot in robots:
        yield from service_findings(robot.name, facts, causes)
        yield from probe_findings(robot.name, facts)
        yield from member_findings(robot.name, facts, config.alarms.offline_after)


def building_findings(
    config: Config, part: Config, loaded: dict[str, FloorFiles], topics: list[TopicFacts]
) -> Iterator[Finding]:
    """Return the findings of floors, maps and places, over all bridges."""
    grids, adapters = {}, adapters_of(part)
    mute = [robot for robot in part.robots if "graph" not in adapters[robot.name].kind.reports]
    for floor in part.floors:
        files = loaded.get(floor.name, FloorFiles())
        yield from floor_findings(config, floor, files, mute, topics)
        surveys = [survey for survey, _ in surveys_of(floor.name, topics) if survey.frame] or [FloorSurvey()]
        grids[floor.name] = placed_grid(files.map, topics, floor.name, surveys[0])
    yield from _places(config, grids, topics)


def _places(
    config: Config, grids: dict[str, OccupancyGrid | None], topics: list[TopicFacts]
) -> Iterator[Finding]:
    """Return the place of each robot that reports it."""
    floors_of = {robot.name: config.floors_of(robot) for robot in config.robots}
    reported = {
        one.robot: one.floor for one in (facts.event for facts in topics) if isinstance(one, FloorReported)
    }
    for facts in topics:
        pose = facts.event
        if isinstance(pose, PoseReported | LocalisationReported):
            floors = floors_of[pose.robot]
            alone = floors[0] if len(floors) == 1 else ""
            yield place_finding(config, pose, grids, floors, reported.get(pose.robot, alone))


def _bridges(whole: Config, config: Config, until: float, take: Take) -> Iterator[BridgeFacts]:
    """Return every bridge that can be reached, after its findings are handed over."""
    names = [name for name, link in config.bridges.items() if not link.is_broker]
    for n, name in enumerate(names):
        share = _share(until, len(names) - n)
        walking = asyncio.run_coroutine_threadsafe(_walk(config, name, share, take), network_loop())
        facts = walking.result()
        if facts is not None:
            _hand_over(bridge_findings(whole, facts), take)
            yield facts


def _share(until: float, left: int) -> float:
    """Return the end of this one's time, of so many left."""
    now = time.monotonic()
    return now + (until - now) / left


def _brokers(whole: Config, config: Config, until: float, take: Take) -> int:
    """Hand over the findings of every broker; returns the number of those reached."""
    names, reached = [name for name, link in config.bridges.items() if link.is_broker], 0
    for n, name in enumerate(names):
        share = _share(until, len(names) - n)
        walking = asyncio.run_coroutine_threadsafe(_to_broker(config, name, share, take), network_loop())
        facts = walking.result()
        if facts is not None:
            _hand_over(broker_findings(whole, facts), take)
            reached += not facts.reason
    return reached


async def _to_broker(config: Config, name: str, until: float, take: Take) -> BrokerFacts | None:
    """Connect to one broker, outside in; None if it can't be reached."""
    approach = Approach(name, config.bridge(name), None, "" if config.path != Path() else "the address")
    async for finding in approach.walk():
        take(finding)
        if finding.is_failure:
            return None
    return await facts_of_broker(config, name, until)


def _all(whole: Config, config: Config, timeout: float, take: Take) -> int:
    """Check everything of `config`, a part of the whole one, in its order, each finding handed over at once;
    returns the number of bridges and brokers reached."""
    until = time.monotonic() + timeout - min(SPARE, timeout / 4)
    for line_ in config.withheld:
        take(Finding("config", "safety", Verdict.WARN, line_))
    with ThreadPoolExecutor(1) as pool:
        loading = pool.submit(_files, config)
        brokers = sum(link.is_broker for link in config.bridges.values())
        reached = list(_bridges(whole, config, _share(until, 2) if brokers else until, take))
        on_brokers = _brokers(whole, config, until, take)
        loaded = loading.result()
    topics = [facts for bridge in reached for facts in bridge.topics]
    if reached or on_brokers or loaded:
        _hand_over(building_findings(whole, config, loaded, topics), take)
    for bridge in reached:
        _hand_over(clock_findings(bridge), take)
    _hand_over(terminal_findings(), take)
    return len(reached) + on_brokers


def _files(config: Config) -> dict[str, FloorFiles]:
    files = dict[str, FloorFiles]()
    for loaded in load_floors(config):
        found = files.get(loaded.floor, FloorFiles())
        match loaded:
            case FloorMapLoaded():
                files[loaded.floor] = found._replace(map=loaded)
            case FloorGraphLoaded():
                files[loaded.floor] = found._replace(graph=loaded)
            case _:
                assert_never(loaded)
    return files


def _hand_over(findings: Iterable[Finding], take: Take) -> None:
    for finding in findings:
        take(finding)


def doctor(
    config: Config,
    timeout: float,
    as_json: bool,
    say: Callable[[str], None],
    robot: str = "",
    unnamed: str = "",
) -> int:
    """Check everything within `timeout` seconds, or one robot only, and print the findings; returns the exit
    code. `unnamed`: the reason that the configuration has no robots, if so."""
    part = only(config, robot) if robot else config
    plain = (sys.stdout.encoding or "ascii").lower().replace("-", "") != "utf8"
    is_tty = sys.stdout.isatty()
    colour = is_tty and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
    width = shutil.get_terminal_size().columns if is_tty else 0
    findings = list[Finding]()

    def take(finding: Finding) -> None:
        findings.append(finding)
        if not as_json:
            say(line(finding, plain, colour, width))

    reached = _all(config, part, timeout, take)
    if unnamed:
        take(Finding(DEFAULT_LINK, "robots", Verdict.FAIL, unnamed))
    broken = any(finding.is_failure or finding.out_of_time for finding in findings)
    code = NO_LINK if not reached else BROKEN if broken else FINE
    say(json.dumps(as_values(findings, time.time(), code)) if as_json else summary(findings, width))
    return code
