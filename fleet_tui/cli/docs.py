"""The `docs` command: the pages of the documentation."""

import os
import re
import shutil
import sys
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path

import click
from click.shell_completion import CompletionItem

from fleet_tui.cli.options import ExampleCommand
from fleet_tui.text.errors import did_you_mean
from fleet_tui.ui.documentation import pages, subject

WIDEST = 110
"""Columns of text on a wide terminal."""

_FENCE = re.compile(r"^( *```)\w+", re.MULTILINE)
_IMAGE = re.compile(r"^!\[.*\n", re.MULTILINE)
_PAGE_LINK = re.compile(r"\[([^\]]+)\]\((?:\.\./|docs/)?([\w-]+)\.md[^)]*\)")
_WHOLE_LINK = re.compile(r"\]\((?:\.\./)?([\w-]+)\.md\)")
_OWN_LINK = re.compile(r"\[([^\]]+)\]\(#[^)]*\)")


def _names(_context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the pages."""
    return [CompletionItem(name) for name in pages() if name.startswith(typed)]


@click.command(cls=ExampleCommand)
@click.argument("page", required=False, shell_complete=_names)
def docs(page: str | None) -> None:
    """Show a page of the documentation, or list the pages. On a terminal in a pager, else as Markdown."""
    known = pages()
    if page is None:
        _print(_listed(known, min(shutil.get_terminal_size().columns, WIDEST)))
    elif page not in known:
        raise click.UsageError(f"unknown page {page!r}{did_you_mean(page, known)}; fleet-tui docs lists them")
    elif sys.stdout.isatty():
        _print(_rendered(known[page].read_text(encoding="utf-8")))
    else:
        click.echo(known[page].read_text(encoding="utf-8"), nl=False)


def _print(text: str) -> None:
    """Print a text, by the pager if it is longer than the terminal."""
    if sys.stdout.isatty() and text.count("\n") >= shutil.get_terminal_size().lines:
        os.environ.setdefault("LESS", "-FRX")  # colours pass, and the text stays when it ends
        click.echo_via_pager(text)
    else:
        click.echo(text)


def _listed(known: Mapping[str, Path], width: int) -> str:
    """Return the pages by purpose: the name of each, and the subject that its first sentence tells."""
    names = max(map(len, known)) + 4
    lines = []
    for purpose, listed in _by_purpose(known):
        about = [(f"  {name}", _about(known[name], width - names)) for name in listed]
        lines += [f"{purpose}:", *(f"{name:<{names}}{text}" for name, text in about), ""]
    return "\n".join([*lines, "Read one with: fleet-tui docs PAGE. Begin with: fleet-tui docs tutorial"])


def _by_purpose(known: Mapping[str, Path]) -> Iterator[tuple[str, list[str]]]:
    """Yield the headings of the index, each with the names of the pages that are linked there as a whole; a
    page belongs to the first."""
    left = set(known)
    for section in known["index"].read_text(encoding="utf-8").split("\n## ")[1:]:
        heading, _, text = section.partition("\n")
        names = [name for name in map(str.casefold, _WHOLE_LINK.findall(text)) if name in left]
        left -= set(names)
        yield heading, list(dict.fromkeys(names))


def _about(path: Path, width: int) -> str:
    """Return the subject of a page, as much of it as fits."""
    text, *parts = subject(path.read_text(encoding="utf-8")).split(", ")
    for part in parts:
        if len(text) + len(part) + 2 > width:
            break
        text = f"{text}, {part}"
    return textwrap.shorten(text, width, placeholder=" ...")


def _rendered(text: str) -> str:
    """Return a page for this terminal: without pictures, and with links as names of pages."""
    from rich.console import Console
    from rich.markdown import Markdown
    from rich.theme import Theme

    text, other = _FENCE.sub(r"\1", _IMAGE.sub("", text)), _PAGE_LINK.search(text)
    text = _OWN_LINK.sub(r"\1", _PAGE_LINK.sub(lambda link: f"{link[1]} [{link[2].casefold()}]", text))
    if other:
        name = other[2].casefold()
        text = f"{text}\n---\n\n[{name}] is another page: `fleet-tui docs {name}`\n"
    width = min(shutil.get_terminal_size().columns, WIDEST)
    console = Console(width=width, force_terminal=True, theme=Theme({"markdown.code": "bold"}))
    with console.capture() as captured:
        console.print(Markdown(text, code_theme="ansi_dark", hyperlinks=False))
    return captured.get()
