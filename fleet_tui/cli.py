"""The command line: reads the config, builds the parts, hands over.

What needs the screen or the simulator is imported where it is used: `check` answers without them.
"""

import gc
from collections.abc import Callable, MutableMapping
from typing import Any, TypeVar

import click

from fleet_tui import __version__
from fleet_tui.config.access import access_problems, unsafe_places
from fleet_tui.config.check import missing_files
from fleet_tui.config.load import find, load, read, user_folder
from fleet_tui.config.schema import Config
from fleet_tui.errors import ConfigError, did_you_mean
from fleet_tui.options import NearestGroup, common, merged, screen
from fleet_tui.simulator.faults import FAULTS, parse_faults

F = TypeVar("F", bound=Callable[..., Any])


class Commands(NearestGroup):
    """The commands. The headless ones are imported when one is asked for."""

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """A command by its name."""
        return super().get_command(ctx, cmd_name) or self._headless().get(cmd_name)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Every command's name."""
        return sorted([*self.commands, *self._headless()])

    def _headless(self) -> MutableMapping[str, click.Command]:
        from fleet_tui.headless.commands import headless

        return headless.commands


FAULT_LIST = "\b\nFaults:\n" + "\n".join(f"  {name:<10}{text}" for name, (text, _) in FAULTS.items())


def _faults(command: F) -> F:
    """What the simulator is to do wrong."""
    return click.option(
        "--fault",
        default="",
        metavar="NAME[:ROBOT],...",
        help="What goes wrong, for every robot or for one; see below.",
    )(command)


@click.group(
    cls=Commands, invoke_without_command=True, context_settings={"help_option_names": ["-h", "--help"]}
)
@click.version_option(__version__, prog_name="fleet-tui")
@screen
@common
@click.pass_context
def commands(
    ctx: click.Context, config_file: str | None, debug: bool, read_only: bool, drawing: str | None
) -> None:
    """The terminal console for robot fleets behind a rosbridge server.

    Without a command it opens the console. `fleet-tui demo` shows it with simulated robots.
    """
    if ctx.invoked_subcommand is None:
        gc.disable()  # until the first paint: it would go through all that is imported again and again
        from fleet_tui.console import open_console

        open_console(load(find(config_file)), read_only, drawing, debug)


@commands.command(epilog=FAULT_LIST)
@click.option("--robots", type=click.IntRange(1, 500), default=3, show_default=True)
@click.option("--floors", type=click.IntRange(1, 20), default=2, show_default=True)
@_faults
@screen
@common
@merged
def demo(
    config_file: str | None,
    debug: bool,
    robots: int,
    floors: int,
    fault: str,
    read_only: bool,
    drawing: str | None,
) -> None:
    """Open the console on a simulated fleet. No ROS, no network."""
    from fleet_tui.demo import simulated

    parse_faults(fault, [f"robot_{n}" for n in range(robots)])
    with simulated(robots, floors, fault) as url:
        from fleet_tui.console import open_console
        from fleet_tui.demo import demo_config

        config = demo_config(load(find(config_file)), url, robots, floors)
        open_console(config, read_only, drawing, debug, demo=True)


@commands.command(epilog=FAULT_LIST)
@click.option("--robots", type=click.IntRange(1, 500), default=3, show_default=True)
@click.option("--floors", type=click.IntRange(1, 20), default=2, show_default=True)
@click.option(
    "--port", type=click.IntRange(0, 65535), default=9090, show_default=True, help="0 takes a free one."
)
@click.option(
    "--rate", type=click.FloatRange(0.1, 100), default=10.0, show_default=True, help="Poses per second."
)
@click.option("--seed", type=int, default=1, show_default=True)
@click.option("--stop-with-stdin", is_flag=True, hidden=True)
@_faults
@common
@merged
def sim(
    config_file: str | None,
    debug: bool,
    robots: int,
    floors: int,
    port: int,
    rate: float,
    seed: int,
    stop_with_stdin: bool,
    fault: str,
) -> None:
    """Serve a simulated fleet to several consoles, until Ctrl-C."""
    from fleet_tui.simulator.run import run

    run(robots, floors, port, rate, seed, lambda url: click.echo(url, nl=True), stop_with_stdin, fault)


@commands.command()
@click.argument("file", required=False)
@common
@merged
def check(config_file: str | None, debug: bool, file: str | None) -> None:
    """Validate a configuration: every problem at once."""
    path = find(file or config_file)
    config, problems = read(path)
    problems += [*missing_files(config), *access_problems(config), *_theme_problems(config)]
    for line in unsafe_places(config):
        click.echo(f"{path}: warning: {line}", err=True)
    if problems:
        raise ConfigError([f"{path}: {line}" for line in problems])
    robots, floors = len(config.robots), len(config.floors)
    click.echo(f"{path}: fine: {robots} robot{'s' * (robots != 1)}, {floors} floor{'s' * (floors != 1)}")


def _theme_problems(config: Config) -> list[str]:
    from fleet_tui.themes import load_themes

    themes, _ = load_themes(user_folder() / "themes")
    if config.ui.theme in themes:
        return []
    return [f"ui.theme: no theme {config.ui.theme!r}{did_you_mean(config.ui.theme, themes)}"]
