"""The `docs` command: the pages of the documentation, which every installation has."""

import re
import shutil
import sys
from collections.abc import Mapping
from pathlib import Path

import click
from click.shell_completion import CompletionItem

from fleet_tui.cli.options import ExampleCommand
from fleet_tui.errors import did_you_mean

PACKAGE = Path(__file__).parents[1]
WIDEST = 110
"""Columns of text on a wide terminal."""

_FENCE = re.compile(r"^( *```)\w+", re.MULTILINE)
_IMAGE = re.compile(r"^!\[.*\n", re.MULTILINE)
_PAGE_LINK = re.compile(r"\[([^\]]+)\]\((?:\.\./|docs/)?([\w-]+)\.md[^)]*\)")
_OWN_LINK = re.compile(r"\[([^\]]+)\]\(#[^)]*\)")


def pages() -> Mapping[str, Path]:
    """Return the pages by name: package data in a wheel, else those of the checkout."""
    shipped = PACKAGE / "docs_shipped"
    root = PACKAGE.parent
    files = [*shipped.glob("*.md")] or [
        *(root / "docs").glob("*.md"),
        root / "SECURITY.md",
        root / "CHANGELOG.md",
    ]
    return {path.stem.casefold(): path for path in sorted(files, key=lambda path: path.stem.casefold())}


def _names(_context: click.Context, _param: click.Parameter, typed: str) -> list[CompletionItem]:
    """Offer the pages."""
    return [CompletionItem(name) for name in pages() if name.startswith(typed)]


@click.command(cls=ExampleCommand)
@click.argument("page", required=False, shell_complete=_names)
def docs(page: str | None) -> None:
    """Show a page of the documentation, or list the pages. On a terminal in a pager, else as Markdown."""
    known = pages()
    if page is None:
        click.echo(_listed(known))
    elif page not in known:
        raise click.UsageError(f"unknown page {page!r}{did_you_mean(page, known)}; fleet-tui docs lists them")
    elif sys.stdout.isatty():
        click.echo_via_pager(_rendered(known[page].read_text(encoding="utf-8")))
    else:
        click.echo(known[page].read_text(encoding="utf-8"), nl=False)


def _listed(known: Mapping[str, Path]) -> str:
    """Return a line for each page: its name and its title."""
    width = max(map(len, known)) + 2
    lines = [f"{name:<{width}}{_title(path)}" for name, path in known.items() if name != "index"]
    return "\n".join([*lines, "", "Read one with: fleet-tui docs PAGE. Begin with: fleet-tui docs tutorial"])


def _title(path: Path) -> str:
    with path.open(encoding="utf-8") as file:
        return file.readline().removeprefix("# ").replace("`", "").strip()


def _rendered(text: str) -> str:
    """Return a page for this terminal: without pictures, and with links as names of pages."""
    from rich.console import Console
    from rich.markdown import Markdown
    from rich.theme import Theme

    text = _FENCE.sub(r"\1", _IMAGE.sub("", text))
    text = _OWN_LINK.sub(r"\1", _PAGE_LINK.sub(lambda link: f"{link[1]} [{link[2].casefold()}]", text))
    width = min(shutil.get_terminal_size().columns, WIDEST)
    console = Console(width=width, force_terminal=True, theme=Theme({"markdown.code": "bold"}))
    with console.capture() as captured:
        console.print(Markdown(text, code_theme="ansi_dark", hyperlinks=False))
    return captured.get()
