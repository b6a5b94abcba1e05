"""The examples: every line is accepted by the command line, and is in the help of its command."""

import shlex
from collections.abc import Iterator
from itertools import takewhile

import click
import pytest

from fleet_tui.cli.examples import EXAMPLES
from fleet_tui.main import commands

LINES = [(path, line) for path, examples in EXAMPLES.items() for line, _ in examples]


def paths(group: click.Group, *before: str) -> Iterator[str]:
    """The words of every command, after `fleet-tui`."""
    for name in group.list_commands(click.Context(group)):
        command = group.get_command(click.Context(group), name)
        yield " ".join((*before, name))
        if isinstance(command, click.Group):
            yield from paths(command, *before, name)


def parsed(args: list[str]) -> click.Context:
    """The context of the command that a line names; its arguments were accepted."""
    context = commands.make_context("fleet-tui", args)
    while isinstance(context.command, click.Group) and context.args + context._protected_args:
        name, command, rest = context.command.resolve_command(
            context, [*context._protected_args, *context.args]
        )
        assert command is not None
        context = command.make_context(name, rest, parent=context)
    return context


def fleet_tui_calls(line: str) -> list[list[str]]:
    """The arguments of each `fleet-tui` in a line for a shell."""
    lexer = shlex.shlex(line, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    words = list(lexer)
    starts = [n for n, word in enumerate(words) if word == "fleet-tui"]
    return [list(takewhile(lambda word: word[0] not in "&|>", words[n + 1 :])) for n in starts]


@pytest.mark.parametrize(("path", "line"), LINES, ids=[line for _, line in LINES])
def test_every_example_is_a_line_that_the_command_accepts(path: str, line: str) -> None:
    contexts = [parsed(args) for args in fleet_tui_calls(line)]
    assert any(f"{context.command_path} ".startswith(f"fleet-tui {path} ") for context in contexts)


@pytest.mark.parametrize("path", sorted({*paths(commands)} - {"completion"}))
def test_every_command_has_examples_in_its_help(path: str) -> None:
    """That of `completion` has a line for each shell."""
    context = click.Context(commands, info_name="fleet-tui", terminal_width=80)
    for name in path.split():
        group = context.command
        assert isinstance(group, click.Group)
        command = group.get_command(context, name)
        assert command is not None
        context = click.Context(command, info_name=name, parent=context, terminal_width=80)
    shown = context.get_help().partition("Examples:\n")[2]
    for line, effect in EXAMPLES[path]:
        assert f"  {line}\n      {effect}\n" in f"{shown}\n"
