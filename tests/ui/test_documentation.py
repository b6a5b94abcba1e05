"""What a page of the documentation is about."""

import re
from pathlib import Path

import fleet_tui
from fleet_tui.ui.documentation import headings, pages, subject

PAGE = """# Metrics

For sites with Prometheus: the [figures](x.md), and `alerts`. More.

## Grafana
"""


def test_the_subject_and_the_headings_of_a_page() -> None:
    assert subject(PAGE) == "the figures, and alerts"
    assert headings(PAGE) == ("Metrics", "Grafana")


def test_every_page_has_both() -> None:
    texts = [path.read_text() for path in pages().values()]
    assert all(subject(text) and headings(text) for text in texts)


def test_each_constant_of_the_limits_is_where_the_page_says() -> None:
    sources = {path: path.read_text() for path in Path(fleet_tui.__file__).parent.rglob("*.py")}
    for named in re.findall(r"`([a-z_/]+)\.([A-Z][A-Z_]+)`", pages()["limits"].read_text()):
        module, constant = named
        defined = re.compile(rf"^\s*(\w+ = )*{constant}\b.*=", re.MULTILINE)
        assert any(
            str(path.with_suffix("")).endswith(f"/{module}") and defined.search(text)
            for path, text in sources.items()
        ), f"{module}.{constant}"
