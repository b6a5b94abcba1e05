"""Reads graph files of any format, recognised by content."""

from collections.abc import Callable
from typing import Any

from fleet_tui.maps.formats import geojson, lif, native, oh, rmf, rmf_building, rmf_site
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices
from fleet_tui.maps.formats.json_text import parse_json
from fleet_tui.maps.formats.yaml_text import parse_yaml, settled
from fleet_tui.model.graphs.document import GraphFormat
from fleet_tui.text.errors import GraphError, did_you_mean
from fleet_tui.text.language import Message

LARGEST = 40_000_000
"""Maximum bytes of a graph file: some 500 for each of the maximum vertices and edges."""
KNOWN = "known formats: native, oh, rmf, rmf-building, rmf-site, geojson, lif, opentcs"
_ALIKE = {GraphFormat.RMF, GraphFormat.RMF_BUILDING}
"""Two formats that a small file does not tell apart."""
_JSON = (GraphFormat.GEOJSON, GraphFormat.LIF, GraphFormat.RMF_SITE)
Read = Callable[[Any, ReadChoices], GraphFile]


def read_graph(text: str, format_: GraphFormat | None, choices: ReadChoices) -> GraphFile:
    """Return the document of a file; `format_` None: recognised by content.

    Raises GraphError, MissingChoiceError where the file leaves something open.
    """
    text = text.removeprefix("\ufeff")
    if not text.strip():
        raise GraphError(Message("empty; {known}", known=KNOWN))
    tree, found = _parsed(text, format_)
    chosen = format_ or found
    if chosen is None:
        raise GraphError(Message("no known format; {known}", known=KNOWN))
    if found is not None and found is not chosen and not {chosen, found} <= _ALIKE:
        raise GraphError(
            Message("not {chosen} but {actual}: leave out --from", chosen=chosen.value, actual=found.value)
        )
    try:
        return _reader(chosen)(tree, choices)
    except RecursionError:
        raise GraphError(Message("nested too deep")) from None


def recognised(text: str) -> GraphFormat | None:
    """Return the format of a text, None if it is of none. Raises GraphError if it can't be parsed."""
    return _parsed(text.removeprefix("\ufeff"), None)[1]


def _parsed(text: str, wanted: GraphFormat | None) -> tuple[Any, GraphFormat | None]:
    """Return the contents of a file, and its format as far as it can be told."""
    first = text.lstrip()[:1]
    if first == "<" or wanted is GraphFormat.OPENTCS:
        from fleet_tui.maps.formats.opentcs import parse_xml  # XML parsers are imported where they are used

        root = parse_xml(text)
        return root, GraphFormat.OPENTCS if root.tag == "model" else None
    if first in ("{", "[") or wanted in _JSON:
        tree = parse_json(text)
        return tree, _format_of(tree)
    tree = parse_yaml(text)
    found = _format_of(tree)
    return (settled(tree) if found in _JSON else tree), found


def _format_of(tree: Any) -> GraphFormat | None:
    """Return the format of a parsed file by its keys."""
    if not isinstance(tree, dict):
        return None
    if native.MARK in tree:
        return GraphFormat.NATIVE
    if tree.get("type") == "FeatureCollection":
        return GraphFormat.GEOJSON
    if isinstance(tree.get("layouts"), list) or lif.is_version_2(tree):
        return GraphFormat.LIF
    if rmf_site.is_site(tree):
        return GraphFormat.RMF_SITE
    if isinstance(tree.get("levels"), dict):
        return GraphFormat.RMF_BUILDING if _is_building(tree) else GraphFormat.RMF
    is_graph = isinstance(tree.get("graph"), dict) and bool(tree["graph"].keys() & {"vertices", "edges"})
    return GraphFormat.OH if is_graph or tree.keys() >= {"vertices", "edges"} else None


def _is_building(tree: dict[str, Any]) -> bool:
    """Tell whether it is the editor's file and not the graph made from it: that has no drawings and walls,
    and its vertices have three parts."""
    if tree.keys() & {"coordinate_system", "crowd_sim", "reference_level_name"}:
        return True
    levels = [level for level in tree["levels"].values() if isinstance(level, dict)]
    if any(level.keys() & {"drawing", "walls", "measurements", "fiducials", "elevation"} for level in levels):
        return True
    lists = [level.get("vertices") for level in levels]
    first = next((one[0] for one in lists if isinstance(one, list) and one), None)
    return isinstance(first, list) and len(first) > 3


def _reader(format_: GraphFormat) -> Read:
    if format_ is GraphFormat.OPENTCS:
        from fleet_tui.maps.formats import opentcs

        return opentcs.read
    readers: dict[GraphFormat, Read] = {
        GraphFormat.NATIVE: native.read,
        GraphFormat.OH: oh.read,
        GraphFormat.RMF: rmf.read,
        GraphFormat.RMF_BUILDING: rmf_building.read,
        GraphFormat.RMF_SITE: rmf_site.read,
        GraphFormat.GEOJSON: geojson.read,
        GraphFormat.LIF: lif.read,
    }
    return readers[format_]


def format_named(word: str) -> GraphFormat:
    """Return a format by its name. Raises GraphError."""
    names = [one.value for one in GraphFormat]
    if word not in names:
        raise GraphError(
            Message(
                "unknown format {word}{did_you_mean}; {known}",
                word=f"{word[:40]!r}",
                did_you_mean=did_you_mean(word, names),
                known=KNOWN,
            )
        )
    return GraphFormat(word)


_RMF = (GraphFormat.RMF, GraphFormat.RMF_BUILDING, GraphFormat.RMF_SITE)
HAS_FLOORS = frozenset({GraphFormat.NATIVE, *_RMF, GraphFormat.LIF})
"""The formats whose files name their floors."""
