"""Opens a ROS bag safely: errors in plain words, and bounded memory."""

import resource
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

SUFFIXES = (".bag", ".db3", ".mcap")
MEMORY = 4 * 2**30
"""Maximum bytes for reading: a few bytes of a compressed bag can expand beyond all memory."""
LARGEST_METADATA = 16 * 2**20
"""Maximum bytes of a metadata.yaml."""
MISSING = Message("ROS bags need rosbags, which is not installed: pip install 'fleet-tui[bags]'")

_REINDEX = "truncated or damaged: repair a ROS 1 bag with `rosbag reindex {name}`"
_RECOVER = "truncated or damaged: repair it with `mcap recover {name} -o mended.mcap`"
# Messages of rosbags (0.11), and their meaning for a person.
_WORDS = {
    "not indexed": f"no index: {_REINDEX}",
    "index looks damaged": _REINDEX,
    "Could not read uint": _REINDEX,
    "Header could not be read": _REINDEX,
    "Got only": _REINDEX,
    "end magic": _RECOVER,
    "MCAP footer": _RECOVER,
    "Truncated record": _RECOVER,
    "seems to be empty": "empty",
    "magic is invalid": "not a bag",
    "missing tables": "not a bag",
}


class BagError(FleetError):
    """A bag that can't be shown, and the remedy."""


def is_bag(path: Path) -> bool:
    """Tell whether a path is a ROS bag, by its name: a folder of ROS 2 or a file."""
    return path.suffix in SUFFIXES or path.is_dir()


class Bag:
    """An open bag. Connections are those of rosbags, one for each topic and publisher or file."""

    def __init__(self, path: Path, reader: Any) -> None:
        self.path = path
        self._reader = reader
        self.is_ros1 = path.suffix == ".bag"
        self.connections: list[Any] = list(reader.connections)

    def messages(self, connections: list[Any]) -> Iterator[tuple[Any, int, bytes]]:
        """Yield the messages of these connections: connection, nanoseconds since 1970, raw message. Raises
        BagError at unreadable data."""
        with _as_message(self.path):
            yield from self._reader.messages(connections)


@contextmanager
def open_bag(path: Path) -> Iterator[Bag]:
    """Open a bag for reading. Raises BagError."""
    try:
        from rosbags.rosbag1 import Reader as Reader1
        from rosbags.rosbag2 import Reader as Reader2
    except ImportError:
        raise BagError(MISSING) from None
    size = _check(path)
    with _bounded(MEMORY, size), _closing(path, Reader1 if path.suffix == ".bag" else Reader2) as reader:
        yield Bag(path, reader)


@contextmanager
def _closing(path: Path, kind: Any) -> Iterator[Any]:
    with _as_message(path):
        reader = kind(path)
        reader.open()
    try:
        yield reader
    finally:
        with suppress(Exception):
            reader.close()


def _check(path: Path) -> int:
    """Return the size of all its files, in bytes. Raises BagError for invalid ones, before any is opened."""
    try:
        if not path.exists():
            raise BagError(Message("{path}: no such file", path=path))
        files = _of_folder(path) if path.is_dir() else [path]
        for file in files:
            if not file.is_file():
                raise BagError(Message("{file}: not a file", file=file))
        return sum(file.stat().st_size for file in files)
    except OSError as problem:
        raise BagError(
            Message("{path}: unreadable: {strerror}", path=path, strerror=problem.strerror)
        ) from None


def _of_folder(path: Path) -> list[Path]:
    inside = sorted(path.iterdir())
    stored = [file for file in inside if file.suffix in SUFFIXES]
    metadata = path / "metadata.yaml"
    if not metadata.exists():
        if not stored:
            raise BagError(
                Message("{path}: not a bag: no metadata.yaml, .bag, .db3 or .mcap in it", path=path)
            )
        names = ", ".join(file.name for file in stored[:3])
        mend = "" if stored[0].suffix == ".bag" else ", or repair it with `ros2 bag reindex`"
        raise BagError(
            Message(
                "{path}: no metadata.yaml in it: name one of its files ({names}){mend}",
                path=path,
                names=names,
                mend=mend,
            )
        )
    if metadata.stat().st_size > LARGEST_METADATA:
        raise BagError(
            Message(
                "{metadata}: is larger than {largest_metadata} bytes: not a metadata.yaml",
                metadata=metadata,
                largest_metadata=f"{LARGEST_METADATA:,}",
            )
        )
    return [file for file in inside if not file.is_dir()]


@contextmanager
def _as_message(path: Path) -> Iterator[None]:
    try:
        yield
    except BagError:
        raise
    except MemoryError:
        raise BagError(
            Message(
                "{path}: needs more than {memory} GB of memory", path=path, memory=f"{MEMORY / 2**30:.0f}"
            )
        ) from None
    except PermissionError:
        raise BagError(Message("{path}: unreadable: Permission denied", path=path)) from None
    except Exception as problem:  # noqa: BLE001  # a damaged bag leads rosbags into errors of every kind
        raise BagError(Message("{path}: {message}", path=path, message=_message(path, problem))) from None


def _message(path: Path, problem: Exception) -> str:
    said = " ".join(str(problem).replace(str(path), path.name).split())
    for part, message in _WORDS.items():
        if part in said:
            return message.format(name=path.name)
    return f"unreadable: {truncate(said or type(problem).__name__)}"


@contextmanager
def _bounded(memory: int, size: int) -> Iterator[None]:
    """Limit memory and unpacked files; `size` is that of the bag."""
    try:
        in_use = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    except OSError:
        # Not on Linux, the only system that enforces the limit of memory.
        yield
        return
    wanted = {resource.RLIMIT_AS: in_use + memory, resource.RLIMIT_FSIZE: 100 * size + 2**30}
    before = {kind: resource.getrlimit(kind) for kind in wanted}
    try:
        for kind, most in wanted.items():
            known = [one for one in before[kind] if one != resource.RLIM_INFINITY]
            resource.setrlimit(kind, (min([most, *known]), before[kind][1]))
        yield
    finally:
        for kind, limits in before.items():
            resource.setrlimit(kind, limits)
