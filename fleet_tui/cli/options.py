"""Options shared by all commands, before or after the command's name; commands and groups with examples."""

import math
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from typing import Any, TypeVar

import click

from fleet_tui.config.trust import saying_yes
from fleet_tui.text.errors import did_you_mean, is_address

F = TypeVar("F", bound=Callable[..., Any])


class ExampleCommand(click.Command):
    """Its help ends with examples."""

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the examples, then the epilog."""
        _write_examples(ctx, formatter)
        super().format_epilog(ctx, formatter)


class NearestGroup(click.Group):
    """Suggests the nearest command for an unknown one; its help lists the commands before the options."""

    command_class = ExampleCommand

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the options, or print the help alone if a command is missing: exit code 2."""
        if not args and self.no_args_is_help and not ctx.resilient_parsing:
            click.echo(ctx.get_help(), err=True)
            sys.exit(2)
        return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command, or suggest one."""
        is_unknown = self.get_command(ctx, args[0]) is None and not args[0].startswith("-")
        if is_unknown and not ctx.resilient_parsing:
            near = did_you_mean(args[0], self.list_commands(ctx))
            ctx.fail(f"unknown command {args[0]!r}{near or self.otherwise(args[0])}")
        return super().resolve_command(ctx, args)

    def otherwise(self, word: str) -> str:
        """Return the end of the message about a word that is similar to no command."""
        return ""

    def sections(self, ctx: click.Context) -> Mapping[str, Sequence[str]]:
        """Return the names of the commands under the headings of the help."""
        return {"Commands": self.list_commands(ctx)}

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the commands, each with its whole summary, then the options."""
        sections = self.sections(ctx)
        width = max(len(name) for names in sections.values() for name in names)
        for heading, names in sections.items():
            rows = [(name.ljust(width), _summary(self.get_command(ctx, name))) for name in names]
            with formatter.section(heading):
                formatter.write_dl(rows)
        click.Command.format_options(self, ctx, formatter)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the examples, then the epilog."""
        _write_examples(ctx, formatter)
        super().format_epilog(ctx, formatter)


def _write_examples(ctx: click.Context, formatter: click.HelpFormatter) -> None:
    """Write a command's examples, each line as it can be copied, with its effect below it."""
    from fleet_tui.cli.examples import EXAMPLES

    path = ctx.command_path.partition(" ")[2]
    if path not in EXAMPLES:
        return
    with formatter.section("Examples"):
        indent = " " * formatter.current_indent
        for line, effect in EXAMPLES[path]:
            formatter.write(f"{indent}{line}\n{indent}    {effect}\n")


def _summary(command: click.Command | None) -> str:
    """Return the first sentence of a command's help."""
    return command.get_short_help_str(limit=200) if command else ""


class FileName(click.Path):
    """The name of an existing file."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Parse the typed text: empty, as from an unset shell variable, it would mean this folder."""
        if value == "":
            self.fail("empty file name: check that the shell variable is set", param, ctx)
        return super().convert(value, param, ctx)


class NumberRange(click.FloatRange):
    """A number within limits."""

    name = "number"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Parse the typed text: `nan` is beyond no limit, and `inf` not beyond a missing one."""
        number = super().convert(value, param, ctx)
        if not math.isfinite(number):
            self.fail(f"{value} is not a number", param, ctx)
        return number


WITH_VALUE = ("--config", "--drawing", "--url")
"""Options of the console with a separate value."""


def with_url(args: list[str]) -> list[str]:
    """Convert an address in place of a command to `--url`."""
    skip = False
    for n, arg in enumerate(args):
        if skip or arg.startswith("-"):
            skip = not skip and arg in WITH_VALUE
        else:
            return [*args[:n], f"--url={arg}", *args[n + 1 :]] if is_address(arg) else args
    return args


def common(command: F) -> F:
    """Add `--config` and `--debug`, which work before and after a command's name."""
    return _config_and_debug(command, "Use this configuration file.")


def appearance(command: F) -> F:
    """Add the same, for a console on robots that are in no configuration."""
    return _config_and_debug(command, "Take theme, keys and the like from this configuration file.")


def without_config(command: F) -> F:
    """Add the same, for commands that read no configuration: they accept `--config`, and don't offer it."""
    return _config_and_debug(command, "")


def _config_and_debug(command: F, use: str) -> F:
    command = click.option(
        "--config", "config_file", type=FileName(), metavar="FILE", help=use, hidden=not use
    )(command)
    command = click.option(
        "--trust-config",
        is_flag=True,
        expose_value=False,
        is_eager=True,
        callback=_trust,
        help="Trust what the configuration and its files contain now, whoever can write them.",
        hidden=not use,
    )(command)
    return click.option("--debug", is_flag=True, help="Show tracebacks and log everything.")(command)


def _trust(ctx: click.Context, _param: click.Parameter, value: bool) -> None:
    if value and not ctx.resilient_parsing:
        ctx.find_root().with_resource(saying_yes())


class Address(click.types.StringParamType):
    """The address of a bridge. Discovery reports its errors."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Parse the typed text: empty, as from an unset shell variable, it would mean another fleet."""
        if not value.strip():
            self.fail("empty address: check that the shell variable is set", param, ctx)
        return super().convert(value, param, ctx)


def fleet(command: F) -> F:
    """Add `--url` as an alternative to `--config`, for commands that talk to robots."""
    text = "Discover the fleet behind this address; needs no configuration."
    return click.option("--url", type=Address(), metavar="URL", help=text)(common(command))


def drawing_mode(command: F) -> F:
    modes = click.Choice(["auto", "braille", "half-block", "ascii"])
    return click.option("--drawing", type=modes, help="Draw the map in this mode.")(command)


def screen(command: F) -> F:
    """Add the options of the console."""
    command = drawing_mode(command)
    return click.option("--read-only", is_flag=True, help="Watch only: send no commands.")(command)


def timeout(seconds: float) -> Callable[[F], F]:
    """Add the maximum duration of a command."""
    limits = NumberRange(0.1, 3600)
    text = "Maximum seconds to wait."
    return click.option(
        "--timeout", type=limits, metavar="SECONDS", default=seconds, show_default=True, help=text
    )


def merged(run: Callable[..., None]) -> Callable[..., None]:
    """Return the options before the command's name, overridden by those after it."""

    @wraps(run)
    @click.pass_context
    def run_merged(ctx: click.Context, /, **options: Any) -> None:
        before = ctx.find_root().params
        for name, value in before.items():
            if value and name not in options:
                ctx.fail(f"--{name.replace('_', '-')} is not an option of {ctx.command.name}")
        run(**{name: value or before.get(name, value) for name, value in options.items()})

    return run_merged
