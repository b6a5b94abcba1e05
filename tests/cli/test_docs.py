"""The `docs` command: lists the pages, shows one, and every page that the program names is there."""

import re
import sys
from pathlib import Path

import pytest

from fleet_tui.ui.documentation import pages
from tests.support.command_line import run
from tests.support.in_pty import Terminal

ROOT = Path(__file__).parents[2]


def test_every_page_is_listed_once_under_its_purpose_with_its_subject(tmp_path: Path) -> None:
    done = run("docs", cwd=tmp_path)
    assert done.returncode == 0
    lines = done.stdout.splitlines()
    assert lines[:2] == [
        "Tutorial:",
        "  tutorial       first a simulated fleet, then your own robots, in ten minutes",
    ]
    assert lines.index("How-to:") < lines.index("Reference:") < lines.index("Design:")
    assert "  connect        Nav2 step by step, the settings for ROS 2, route graphs" in lines
    names = {path.stem for path in (ROOT / "docs").glob("*.md")}
    assert set(pages()) == names | {"security", "changelog"}
    listed = [line.split()[0] for line in lines if re.match(r"  \S", line)]
    assert sorted(listed) == sorted({*pages()} - {"index"})
    assert max(map(len, lines)) <= 80


def test_every_page_begins_with_its_readers_and_its_subject() -> None:
    openings = {name: " ".join(path.read_text().split("\n\n")[1].split()) for name, path in pages().items()}
    assert [name for name in openings if not re.match(r"For [^:.]+: .+\.", openings[name])] == ["index"]


def test_in_a_pipe_a_page_is_markdown(tmp_path: Path) -> None:
    assert run("docs", "cli", cwd=tmp_path).stdout == (ROOT / "docs" / "cli.md").read_text()


def test_an_unknown_page_is_answered_with_the_nearest(tmp_path: Path) -> None:
    done = run("docs", "tutorail", cwd=tmp_path)
    assert done.returncode == 2
    assert "unknown page 'tutorail', did you mean tutorial?" in done.stderr


def test_on_a_terminal_a_page_is_text_without_markup(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PAGER", "cat")
    terminal = Terminal([sys.executable, "-m", "fleet_tui", "docs", "tutorial"], tmp_path)
    try:
        terminal.wait_for("Connect a stack [connect]: ")
        terminal.wait_for("[installing] is another page: fleet-tui docs installing")
    finally:
        terminal.close()


def test_a_pager_gets_what_is_longer_than_the_terminal_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pager = tmp_path / "pager"
    pager.write_text("#!/bin/sh\nexec sed s/^/paged:/\n")
    pager.chmod(0o755)
    monkeypatch.setenv("PAGER", str(pager))
    for page, is_paged in (([], False), (["connect"], True)):
        terminal = Terminal([sys.executable, "-m", "fleet_tui", "docs", *page], tmp_path)
        try:
            terminal.wait_for("paged:" if is_paged else "Begin with: fleet-tui docs tutorial")
            assert ("paged:" in terminal.text()) is is_paged
        finally:
            terminal.close()


def test_completion_offers_the_pages(tmp_path: Path) -> None:
    asked = {"_FLEET_TUI_COMPLETE": "bash_complete", "COMP_WORDS": "fleet-tui docs st", "COMP_CWORD": "2"}
    assert run(cwd=tmp_path, **asked).stdout.split() == ["plain,status-json"]


def test_every_page_that_the_program_names_is_there() -> None:
    texts = [path.read_text() for path in (ROOT / "fleet_tui").rglob("*.py")]
    named = {name for text in texts for name in re.findall(r"fleet-tui docs ([a-z][a-z-]*)", text)}
    assert "status-json" in named and named - {"lists"} <= set(pages())


def test_every_link_between_pages_leads_to_a_page_and_a_heading() -> None:
    pages_of_the_project = {path.resolve(): path.read_text() for path in pages().values()}
    for name in ("README.md", "CONTRIBUTING.md"):
        pages_of_the_project[ROOT / name] = (ROOT / name).read_text()
    lost = [
        f"{path.name}: {target}"
        for path, text in pages_of_the_project.items()
        for target in re.findall(r"\]\(([^)\s]+)\)", text)
        if not target.startswith("http") and not _exists(path, target, pages_of_the_project)
    ]
    assert lost == []


def _exists(page: Path, target: str, known: dict[Path, str]) -> bool:
    name, _, heading = target.partition("#")
    path = (page.parent / name).resolve() if name else page
    return path.exists() and (not heading or heading in _anchors(known[path]))


def _anchors(text: str) -> set[str]:
    """The names that GitHub gives to the headings of a page."""
    titles = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}
