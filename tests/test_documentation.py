"""What a page of the documentation is about."""

from fleet_tui.documentation import headings, pages, subject

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
