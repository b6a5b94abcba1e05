"""The types of a bag's messages, from the definitions in it.

rosbags generates Python code from names and numbers of a definition, and runs it. So here a definition is
checked, and only plain names and small numbers pass.
"""

import re
from typing import Any

from fleet_tui.features.recording.bags.opening import BagError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, truncate

LONGEST = 500_000
"""Maximum characters of a definition with all referenced ones."""
MOST_VALUES = 100_000
DEEPEST = 50
"""Maximum values of a message, those in lists of variable size counted once, and maximum nesting."""
LONGEST_LIST = 2**27
"""Maximum values of one list of a message."""

_INTEGERS = {f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)}
BASE = frozenset({"bool", "byte", "char", "float32", "float64", "string", *_INTEGERS})
BUILT_IN = {
    "time": "builtin_interfaces/msg/Time",
    "duration": "builtin_interfaces/msg/Duration",
    "Header": "std_msgs/msg/Header",
}
TIMES = frozenset({BUILT_IN["time"], BUILT_IN["duration"]})

_PART = re.compile(r"^={3,}[ \t]*$", re.MULTILINE)
_FIELD = re.compile(
    r"(?P<type>[A-Za-z][\w/]*)(?:<=\d{1,9})?(?P<list>\[(?:<=)?(?P<size>\d{0,9})\])?"
    r"[ \t]+(?P<name>[A-Za-z]\w*)[ \t]*(?P<constant>=)?",
    re.ASCII,
)
_TYPE_NAME = re.compile(r"[A-Za-z]\w*(?:/[A-Za-z]\w*){2,3}", re.ASCII)
_FIELD_NAME = re.compile(r"[A-Za-z]\w*", re.ASCII)

Fields = list[tuple[str, Any]]
Types = dict[str, tuple[list[Any], Fields]]
"""In the format of rosbags: for each type its constants, unused here, and its fields."""


def typestore(connection: Any) -> Any:
    """Return the reader of a connection's messages. Raises BagError with the type's name."""
    from rosbags.interfaces import MessageDefinitionFormat
    from rosbags.typesys import Stores, get_typestore

    name = connection.msgtype
    form, text = connection.msgdef
    if form is MessageDefinitionFormat.NONE:
        store = get_typestore(Stores.ROS2_HUMBLE)
        if name not in store.fielddefs:
            raise BagError(
                Message(
                    "the definition of {type} is not in the bag: record as mcap, or with ROS 2 Iron or newer",
                    type=truncate(name, LONGEST_NAME),
                )
            )
    else:
        if len(text) > LONGEST:
            raise BagError(
                Message(
                    "the definition of {type} has {count} characters",
                    type=truncate(name, LONGEST_NAME),
                    count=f"{len(text):,}",
                )
            )
        types = _of_msg(text, name) if form is MessageDefinitionFormat.MSG else _of_idl(text)
        _Check(types, name)
        store = get_typestore(Stores.EMPTY)
        store.register(types)
    store.max_sequence_length = LONGEST_LIST
    return store


def _of_idl(text: str) -> Types:
    from rosbags.typesys import get_types_from_idl

    mark = "=" * 80 + "\nIDL: "
    parts = [part.partition("\n")[2] for part in text.split(mark)[1:]] if text.startswith(mark) else [text]
    found: Types = {}
    for part in parts:
        for name, (_, fields) in get_types_from_idl(part).items():
            found[name] = [], fields
    return found


def _of_msg(text: str, name: str) -> Types:
    first, *others = _PART.split(text)
    found: Types = {name: ([], _fields(first, name))}
    for part in others:
        head, _, body = part.lstrip().partition("\n")
        other = _whole(head.removeprefix("MSG:").strip(), name)
        found[other] = [], _fields(body, other)
    return found


def _fields(text: str, owner: str) -> Fields:
    """Return the fields of one message, without constants and default values."""
    from rosbags.interfaces import Nodetype

    found: Fields = []
    for line in text.splitlines():
        line = line.partition("#")[0].strip()
        field = _FIELD.match(line)
        if field is None:
            if line and not line.startswith("@"):
                raise BagError(
                    Message(
                        "the definition of {owner} has an invalid line: {text}",
                        owner=owner,
                        text=f"{truncate(line, 80)!r}",
                    )
                )
            continue
        if field["constant"]:
            continue
        kind = field["type"]
        inner = (Nodetype.BASE, (kind, 0)) if kind in BASE else (Nodetype.NAME, _whole(kind, owner))
        is_fixed = field["list"] and field["size"] and "<" not in field["list"]
        outer = Nodetype.ARRAY if is_fixed else Nodetype.SEQUENCE
        found.append((field["name"], (outer, (inner, int(field["size"] or 0))) if field["list"] else inner))
    return found


def _whole(kind: str, owner: str) -> str:
    """Return a type's whole name, resolved in a definition of the owner."""
    if kind in BUILT_IN:
        return BUILT_IN[kind]
    package, _, name = kind.rpartition("/")
    if not package:
        return f"{owner.rpartition('/')[0]}/{name}"
    return kind if "/" in package else f"{package}/msg/{name}"


class _Check:
    """Raises BagError for a definition from which rosbags would generate invalid or too much code."""

    def __init__(self, types: Types, wanted: str) -> None:
        self._types = types
        self._about = f"the definition of {truncate(wanted, LONGEST_NAME)}"
        self._values: dict[str, int] = {}
        self._message(wanted, 0)

    def _message(self, name: str, depth: int) -> int:
        """Return the number of values in a message."""
        if name in TIMES:
            return 2
        if name not in self._types or not _TYPE_NAME.fullmatch(name):
            raise BagError(
                Message("{about} lacks {name}", about=self._about, name=truncate(name, LONGEST_NAME))
            )
        if depth > DEEPEST:
            raise BagError(Message("{about} is nested too deep", about=self._about))
        if name not in self._values:
            self._values[name] = 1 + sum(self._field(*field, depth) for field in self._types[name][1])
        if self._values[name] > MOST_VALUES:
            raise BagError(
                Message(
                    "{about} has more than {most_values} values",
                    about=self._about,
                    most_values=f"{MOST_VALUES:,}",
                )
            )
        return self._values[name]

    def _field(self, name: str, desc: Any, depth: int) -> int:
        from rosbags.interfaces import Nodetype

        if not _FIELD_NAME.fullmatch(name):
            raise BagError(Message("{about} has a field without a plain name", about=self._about))
        kind, what = desc
        times = 1
        if kind in (Nodetype.ARRAY, Nodetype.SEQUENCE):
            # Code is generated for each part of fixed size, except for numbers.
            times = what[1] if kind == Nodetype.ARRAY else 1
            kind, what = what[0]
        if kind == Nodetype.NAME:
            return times * self._message(what, depth + 1)
        if what[0] not in BASE:
            raise BagError(
                Message(
                    "{about} has {name}, which is not supported",
                    about=self._about,
                    name=truncate(str(what[0]), 20),
                )
            )
        return times if what[0] == "string" else 1
