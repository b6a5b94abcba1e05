"""A configuration as text: the findings behind a bridge, ready to edit. Pure."""

import json
from collections.abc import Iterator, Mapping
from types import MappingProxyType

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.choices import floors_of, strange_frames
from fleet_tui.links.discovery.recognition import Found
from fleet_tui.model.order import natural
from fleet_tui.robots.discovery import NAME, Discovery
from fleet_tui.robots.registry import DEFAULT_KIND, KINDS

FIRST = "# fleet-tui: discovered on this {}. Validate with `fleet-tui check`."
ROLE = '# role = "watch"   # or "pause", or "master": what this console may command'
BROKER = "broker"
"""The name of the link to a broker."""
UNKNOWN_FLOOR = "floor_0"
"""The name of the one floor where no pose has named a map."""
NO_ROBOTS = "# No robot topics found. Name the robots here and their topics in [profile.topics]."


def render(
    bridge: Link, found: Found, frames: Mapping[str, str], placed: Mapping[str, str] = MappingProxyType({})
) -> str:
    """Return a configuration as text. `frames`: of poses whose frame means a floor, by robot; `placed`: those
    that a person assigned to floors."""
    server, table = ("broker", f"[links.{BROKER}]") if bridge.is_broker else ("bridge", "[rosbridge]")
    lines = [FIRST.format(server), "", table, *_differing(bridge), *([ROLE] if bridge.is_broker else ())]
    lines += ["", *_floors(found, frames, placed)]
    usual = next(iter(found))
    lines += _robots(found, usual)
    if not any(one.robots for one in found.values()):
        return "\n".join([*lines, NO_ROBOTS, "[[robots]]", 'name = "robot_0"']) + "\n"
    for kind, one in found.items():
        lines += _profile(kind, one, "profile" if kind == usual else f"profiles.{kind}")
    return "\n".join(lines).rstrip() + "\n"


def _robots(found: Found, usual: str) -> Iterator[str]:
    """Return each robot, those of several kinds in the order of their names."""
    all_floors = floors_of(found)
    robots = [(name, kind) for kind, one in found.items() for name in one.robots]
    for name, kind in sorted(robots, key=lambda robot: natural(robot[0])):
        floors = found[kind].robots[name]
        yield from ("[[robots]]", f"name = {_text(name)}")
        if kind != usual:
            yield f"profile = {_text(kind)}"
        if floors and floors != all_floors:
            yield f"floors = {_text(floors)}"
        if name in found[kind].vehicles:
            manufacturer, serial = found[kind].vehicles[name]
            yield f"manufacturer = {_text(manufacturer)}"
            yield f"serial = {_text(serial)}"
            yield f"link = {_text(BROKER)}"
        yield from ("# size = [0.9, 0.6]           # length, width in metres", "")


def _profile(kind: str, found: Discovery, where: str) -> Iterator[str]:
    """Return the tables in which a profile differs from the usual one of its kind."""
    if kind != DEFAULT_KIND:
        yield from (f"[{where}]", f"kind = {_text(kind)}", "")
    for table in ("topics", "types", "services", "service_types", "actions"):
        entries: dict[str, str] = getattr(found, table)
        notes = found.notes.get(table, [])
        if entries or notes:
            yield f"[{where}.{table}]"
            yield from (f"{key} = {_text(value)}" for key, value in entries.items())
            yield from (f"# {note}" for note in notes)
            yield ""


def _text(value: object) -> str:
    """Return a string or a list of them as TOML, in ASCII: JSON except for surrogate pairs."""
    text = json.dumps(value, ensure_ascii=False)
    return "".join(
        letter if letter.isprintable() and letter < "\x7f" else f"\\U{ord(letter):08x}" for letter in text
    )


def _differing(bridge: Link) -> Iterator[str]:
    """Return the settings of a bridge that differ from the defaults, the address always."""
    usual = Link()
    for name in bridge.__struct_fields__:
        value = getattr(bridge, name)
        if name == "url" or value != getattr(usual, name):
            yield f"{name} = {_text(value)}"


def _floors(found: Found, frames: Mapping[str, str], placed: Mapping[str, str]) -> Iterator[str]:
    """Return each floor, with the frame of the poses on it, if known."""
    floors = floors_of(found)
    live = {floor for one in found.values() for floor in one.live_maps}
    needs_graph = {floor for kind, one in found.items() if _has_no_graph(kind) for floor in one.floors}
    strange = [frame for frame in strange_frames(found, frames) if frame not in placed.values()]
    if not floors:
        yield "# No floor topics found: floors are named after the pose frames."
        named = {floor_name(frame, n): frame for n, frame in enumerate(strange)} or {UNKNOWN_FLOOR: ""}
        floors, strange = list(named), []
        needs_graph = {floor for floor in floors if any(map(_has_no_graph, found))}
        placed = {**{floor: frame for floor, frame in named.items() if frame not in ("", floor)}, **placed}
    for floor in floors:
        yield from ("[[floors]]", f"name = {_text(floor)}")
        if floor in placed or len(floors) == 1 == len(strange):
            yield f"frame_id = {_text(placed.get(floor) or strange[0])}"
        shown = "the live map is used; or a" if floor in live else "no live map:"
        yield f'# map = "maps/{floor}.yaml"   # {shown} map_server YAML, or a plain PNG/PGM'
        if floor in needs_graph:
            suffix = "lif.json" if "vda5050" in found else "geojson"
            yield f'# graph = "maps/{floor}.{suffix}"   # route graph, for robots that publish none'
        yield ""
    if strange and len(floors) > 1:
        yield from (
            f"# Poses also use frame {_text(one)}: set it as frame_id of its floor." for one in strange
        )
        yield ""


def floor_name(frame: str, number: int) -> str:
    """Return the name of a floor by the frame of its poses, which may be any text."""
    return frame if NAME.fullmatch(frame) else f"floor_{number}"


def _has_no_graph(kind: str) -> bool:
    return not {"graph", "graphs"} & KINDS[kind].vocabulary.topics.keys()
