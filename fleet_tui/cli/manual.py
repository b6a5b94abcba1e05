"""The manual page: every command with its options, from the table that the command line itself uses."""

import inspect
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Iterator, Set
from datetime import date

import click

from fleet_tui import __version__
from fleet_tui.cli.examples import EXAMPLES
from fleet_tui.cli.options import ExampleCommand

ENDING = r""".SH EXIT STATUS
.TP
0
success
.TP
1
the command or check failed, or something needs attention
.TP
2
usage or configuration error
.TP
3
no link
.TP
130
Ctrl\-C
.SH FILES
.TP
\fI./config.toml\fR, \fI~/.config/fleet\-tui/config.toml\fR
the configuration, unless \fB\-\-config\fR or \fB$FLEET_TUI_CONFIG\fR
names another
.TP
\fI~/.local/state/fleet\-tui/\fR
audit log, log and recordings
.SH ENVIRONMENT
.TP
\fBFLEET_TUI_CONFIG\fR
the configuration, unless \fB\-\-config\fR names one
.TP
\fBXDG_CONFIG_HOME\fR, \fBXDG_STATE_HOME\fR
folders in place of \fI~/.config\fR and \fI~/.local/state\fR
.TP
\fBNO_COLOR\fR
if set: no colours
.TP
\fBPAGER\fR
the program in which \fBfleet\-tui docs\fR shows a page
.TP
\fBSHIV_ROOT\fR
the folder to which the single file unpacks itself
.SH SEE ALSO
\fBfleet\-tui docs\fR lists the pages of the documentation.
"""


@click.command(cls=ExampleCommand)
@click.pass_context
def man(ctx: click.Context) -> None:
    """Show the manual page. In a pipe or into a file it prints its source."""
    page = manual(ctx.find_root())
    if sys.stdout.isatty() and shutil.which("man"):
        subprocess.run(["man", "-l", "-"], input=page, text=True, check=False)
    else:
        click.echo(page, nl=False)


def manual(root: click.Context) -> str:
    """Return the page `fleet-tui.1` in the language of man(7)."""
    command = root.command
    lines = [
        f'.TH FLEET\\-TUI 1 "{date.today()}" "fleet\\-tui {__version__}" "User Commands"',
        ".nh",
        ".SH NAME",
        rf"fleet\-tui \- {_roff(command.get_short_help_str(200).rstrip('.'))}",
        ".SH SYNOPSIS",
        rf"\fBfleet\-tui\fR {_roff(' '.join(command.collect_usage_pieces(root)))}",
        ".SH DESCRIPTION",
        *_paragraphs(command.help or ""),
        ".SH OPTIONS",
        *_options(root, frozenset()),
        ".SH COMMANDS",
        *_filled("The options above may also follow a command that uses them."),
    ]
    known = {name for param in command.get_params(root) for name in param.opts}
    for context in _below(root):
        usage = [context.command_path.removeprefix(f"{root.info_name} ")]
        usage += context.command.collect_usage_pieces(context)
        lines += [f'.SS "{_roff(" ".join(usage))}"', *_paragraphs(context.command.help or "")]
        lines += [*_options(context, known), *_paragraphs(context.command.epilog or "")]
    return "\n".join([*lines, *_examples(), ENDING])


def _examples() -> Iterator[str]:
    """Return the examples of all commands, each with its effect."""
    yield ".SH EXAMPLES"
    for examples in EXAMPLES.values():
        for line, effect in examples:
            yield from (".TP", rf"\fB{_roff(line)}\fR", *_filled(effect))


def _below(context: click.Context) -> Iterator[click.Context]:
    """Return every command below this one, a group before its own."""
    group = context.command
    if isinstance(group, click.Group):
        for name in group.list_commands(context):
            if command := group.get_command(context, name):
                inner = click.Context(command, info_name=name, parent=context)
                yield inner
                yield from _below(inner)


def _options(context: click.Context, known: Set[str]) -> Iterator[str]:
    """Return the options that are not known from elsewhere, each with its help."""
    for param in context.command.get_params(context):
        record = param.get_help_record(context)
        if record and isinstance(param, click.Option) and known.isdisjoint(param.opts):
            yield from (".TP", rf"\fB{_roff(record[0])}\fR", *_filled(record[1]))


def _paragraphs(text: str) -> Iterator[str]:
    """Return the paragraphs of a help text; click's \\b keeps the lines of one."""
    for number, paragraph in enumerate(filter(None, inspect.cleandoc(text).split("\n\n"))):
        if number:
            yield ".PP"
        if "\b" in paragraph:
            yield from (".nf", *map(_roff, paragraph.replace("\b", "").strip("\n").splitlines()), ".fi")
        else:
            yield from _filled(paragraph)


def _filled(text: str) -> Iterator[str]:
    """Return text as short lines, which a reader's terminal fills."""
    words = " ".join(text.split())
    yield from map(_roff, textwrap.wrap(words, 70, break_long_words=False, break_on_hyphens=False))


def _roff(text: str) -> str:
    """Return text that man(7) prints as it is."""
    written = text.replace("\\", r"\e").replace("-", r"\-").replace('"', r"\(dq")
    return rf"\&{written}" if written.startswith((".", "'")) else written
