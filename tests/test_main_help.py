"""The help: whole sentences at 80 columns, the commands by purpose, and where to read on."""

from collections.abc import Iterator

import click
import pytest

from fleet_tui.main import SECTIONS, commands

ROOT = click.Context(commands, info_name="fleet-tui", terminal_width=80)


def below(context: click.Context) -> Iterator[click.Context]:
    """The command line and every command of it."""
    yield context
    group = context.command
    if isinstance(group, click.Group):
        for name in group.list_commands(context):
            command = group.get_command(context, name)
            assert command is not None
            yield from below(click.Context(command, info_name=name, parent=context, terminal_width=80))


ALL = {context.command_path: context for context in below(ROOT)}


@pytest.mark.parametrize("context", ALL.values(), ids=ALL)
def test_no_line_is_cut_or_wider_than_80_columns(context: click.Context) -> None:
    text = context.get_help()
    assert [line for line in text.splitlines() if len(line) > 80] == []
    summaries = text.partition("Options:")[0].partition("\n")[2]
    assert [line for line in summaries.splitlines() if line.endswith(("...", "…"))] == []


@pytest.mark.parametrize("context", ALL.values(), ids=ALL)
def test_each_command_is_summed_up_on_one_line_of_its_groups_help(context: click.Context) -> None:
    assert context.command.help
    if context.parent is not None:
        lines = context.parent.get_help().splitlines()
        summary = context.command.get_short_help_str(limit=200)
        assert any(line.split() == [str(context.info_name), *summary.split()] for line in lines), summary


def test_every_command_is_under_one_heading() -> None:
    named = [name for names in SECTIONS.values() for name in names]
    assert sorted(named) == commands.list_commands(ROOT)


def test_the_help_begins_with_what_a_newcomer_needs_and_ends_with_where_to_read_on() -> None:
    text = ROOT.get_help()
    places = [
        text.index(f"\n  {name} ") for name in ("demo", "config", "doctor", "status", "order", "cancel")
    ]
    assert places == sorted(places)
    assert places[-1] < text.index("Options:") < text.index("Read on:")
    assert "fleet-tui docs tutorial" in text.splitlines()[-1]
