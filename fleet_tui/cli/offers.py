"""Values that shell completion offers for options and arguments."""

from collections.abc import Callable, Iterable

import click
from click.shell_completion import CompletionItem

from fleet_tui.config.load import find, read
from fleet_tui.config.schema import Config
from fleet_tui.text.errors import ConfigError

PLAIN = "_-./:,+@%="
"""Characters beside letters and digits that no shell reads."""

Offer = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def files(_context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the shell's own completion of file names."""
    return [CompletionItem(typed, type="file")]


def robots(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the robots of the configuration."""
    return starting((robot.name for robot in config_of(context).robots), typed)


def places(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the labels in the graph files of the configuration. Without a file only the robots know them."""
    from fleet_tui.maps.floor_files import load_graphs

    labels = (label for loaded in load_graphs(config_of(context)) for label in loaded.labels.values())
    return starting(dict.fromkeys(labels), typed)


def programs(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the programs of the configuration."""
    return starting((program.name for program in config_of(context).programs), typed)


def one_of(words: Iterable[str]) -> Offer:
    """Return an offer of these words."""
    return lambda _context, _param, typed: starting(words, typed)


def listed(words: Callable[[click.Context], Iterable[str]]) -> Offer:
    """Return an offer of one more word for a list with commas."""

    def offer(context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
        before, comma, last = typed.rpartition(",")
        return [CompletionItem(f"{before}{comma}{word.value}") for word in starting(words(context), last)]

    return offer


def starting(names: Iterable[str], typed: str) -> list[CompletionItem]:
    """Return the names that begin as typed, of those that every shell takes as they are: the configuration
    may be somebody else's, and what is completed is run."""
    return [CompletionItem(name) for name in names if name.startswith(typed) and _is_plain(name)]


def _is_plain(name: str) -> bool:
    """Tell whether no character of a name means anything to a shell or a terminal."""
    return name[:1] not in ("-", "=") and all(letter.isalnum() or letter in PLAIN for letter in name)


def config_of(context: click.Context) -> Config:
    """Return the configuration of the typed line, as far as it can be read."""
    given = context.params.get("config_file") or context.find_root().params.get("config_file")
    try:
        return read(find(given))[0]
    except ConfigError:
        return Config()
