"""The command line: reads the config, builds the parts, and runs them.

Screen and simulator are imported on use: `check` works without them.
"""

import gc
from collections.abc import Mapping, Sequence

import click

from fleet_tui import __version__
from fleet_tui.cli.completion import completion
from fleet_tui.cli.options import FileName, NearestGroup, common, fleet, merged, screen, with_url
from fleet_tui.config.access import access_problems
from fleet_tui.config.check import missing_files
from fleet_tui.config.load import find, read, user_folder
from fleet_tui.config.log_file import state_problem
from fleet_tui.config.schema import Config
from fleet_tui.console.launch import open_with
from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.text.errors import ConfigError, did_you_mean
from fleet_tui.text.sanitize import sanitize

SECTIONS = {
    "Most needed": ("demo", "config", "doctor", "status", "order"),
    "Command robots": ("cancel", "clear", "pause", "resume", "goto", "run", "programs", "routine"),
    "Set up a site": (
        "check",
        "kinds",
        "map",
        "graph",
        "mapping",
        "set-pose",
        "localise",
        "settle",
        "store-map",
        "store-pose-graph",
    ),
    "Logs and recordings": ("history", "report", "audit", "record", "replay"),
    "Other ways to use it": ("serve", "metrics", "sim", "rights", "docs", "man", "completion"),
}
"""The headings of the help with their commands."""

READ_ON = """\b
Read on:
  fleet-tui COMMAND --help   options and exit codes of a command
  fleet-tui man              all commands on one page
  ? in the console           its keys and tasks
  fleet-tui docs tutorial    your first robot; fleet-tui docs lists all guides
"""


class Commands(NearestGroup):
    """The commands. Most are imported on use: the console starts without them."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read an address in a command's place as --url."""
        return super().parse_args(ctx, with_url(args))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        return super().get_command(ctx, cmd_name) or self._others().get(cmd_name)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return every command's name."""
        return sorted([*self.commands, *self._others()])

    def sections(self, ctx: click.Context) -> Mapping[str, Sequence[str]]:
        """Return the commands by purpose, those a newcomer needs first."""
        return SECTIONS

    def otherwise(self, word: str) -> str:
        """Return the way to write an address: the word may be the name of a host."""
        return "; an address begins with ws://, for example fleet-tui ws://robot-server:9090"

    def _others(self) -> dict[str, click.Command]:
        from fleet_tui.console.replay import replayed
        from fleet_tui.console.shell import headless
        from fleet_tui.console.simulate import simulated
        from fleet_tui.features.serve.cli import served

        return {**headless.commands, **simulated.commands, **served.commands, **replayed.commands}


@click.group(
    cls=Commands,
    invoke_without_command=True,
    subcommand_metavar="[URL | COMMAND [ARGS]...]",
    epilog=READ_ON,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, prog_name="fleet-tui")
@screen
@fleet
@click.pass_context
def commands(
    ctx: click.Context,
    config_file: str | None,
    url: str | None,
    debug: bool,
    read_only: bool,
    drawing: str | None,
) -> None:
    """Watch and command robot fleets behind a rosbridge server.

    \b
    fleet-tui                   open the console on the configuration found
    fleet-tui ws://HOST:9090    find the robots behind this rosbridge and open
    fleet-tui demo              no robots at hand: open a simulated fleet
    """
    if ctx.invoked_subcommand is None:
        gc.disable()  # until the first paint: collecting while so much is imported takes 80 ms
        open_with(config_file, url, read_only, drawing, debug)


@commands.command()
@click.argument("file", type=FileName(), required=False)
@common
@merged
def check(config_file: str | None, debug: bool, file: str | None) -> None:
    """Validate a configuration and list all problems."""
    path = find(file or config_file)
    config, problems = read(path)
    problems += [*missing_files(config), *_graph_problems(config)]
    problems += [*access_problems(config), *_theme_problems(config)]
    for line in filter(None, (*config.withheld, state_problem())):
        click.echo(sanitize(f"{path}: warning: {line}"), err=True)
    if problems:
        raise ConfigError([f"{path}: {line}" for line in problems])
    robots, floors = len(config.robots), len(config.floors)
    counts = f"{robots} robot{'s' * (robots != 1)}, {floors} floor{'s' * (floors != 1)}"
    click.echo(f"{sanitize(str(path))}: valid: {counts}")


commands.add_command(completion)


def _graph_problems(config: Config) -> list[str]:
    """Return the errors in existing graph files."""
    files = [(n, one.name, config.beside(one.graph)) for n, one in enumerate(config.floors) if one.graph]
    loaded = [(n, load_floor_graph(name, path)) for n, name, path in files if path.is_file()]
    return [f"floors[{n}].graph: {graph.problem}" for n, graph in loaded if graph.problem]


def _theme_problems(config: Config) -> list[str]:
    from fleet_tui.ui.themes import load_themes  # imports rich

    themes, _ = load_themes(user_folder() / "themes")
    if config.ui.theme in themes:
        return []
    return [f"ui.theme: unknown theme {config.ui.theme!r}{did_you_mean(config.ui.theme, themes)}"]
