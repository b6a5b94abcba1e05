"""Values that shell completion offers for options and arguments."""

from collections.abc import Callable, Iterable

import click
from click.shell_completion import CompletionItem

from fleet_tui.config.load import find, read
from fleet_tui.config.schema import Config
from fleet_tui.errors import ConfigError
from fleet_tui.text.sanitize import sanitize

Offer = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def files(_context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the shell's own completion of file names."""
    return [CompletionItem(typed, type="file")]


def robots(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the robots of the configuration."""
    return _starting((robot.name for robot in _config(context).robots), typed)


def places(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the labels in the graph files of the configuration. Without a file only the robots know them."""
    from fleet_tui.maps.floor_files import load_graphs

    labels = (label for loaded in load_graphs(_config(context)) for label in loaded.labels.values())
    return _starting(dict.fromkeys(labels), typed)


def programs(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the programs of the configuration."""
    return _starting((program.name for program in _config(context).programs), typed)


def routines(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the files in the configuration's folder of routines."""
    from fleet_tui.routines.files import routine_names

    return _starting(routine_names(_config(context).routine_folder), typed)


def one_of(words: Iterable[str]) -> Offer:
    """Return an offer of these words."""
    return lambda _context, _param, typed: _starting(words, typed)


def listed(words: Callable[[click.Context], Iterable[str]]) -> Offer:
    """Return an offer of one more word for a list with commas."""

    def offer(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
        before, comma, last = typed.rpartition(",")
        return [CompletionItem(f"{before}{comma}{word}") for word in words(context) if word.startswith(last)]

    return offer


def _starting(names: Iterable[str], typed: str) -> list[CompletionItem]:
    """Return the names that begin as typed, without those that a shell or terminal would read differently."""
    return [
        CompletionItem(name)
        for name in names
        if name.startswith(typed) and sanitize(name) == name and not any(map(str.isspace, name))
    ]


def _config(context: click.Context) -> Config:
    """Return the configuration of the typed line, as far as it can be read."""
    given = context.params.get("config_file") or context.find_root().params.get("config_file")
    try:
        return read(find(given))[0]
    except ConfigError:
        return Config()
