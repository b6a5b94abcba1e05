"""Elements: whatever is said in them is text."""

from html.parser import HTMLParser
from xml.etree.ElementTree import tostring

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.history.report.html import element, table
from fleet_tui.text.sanitize import sanitize


class Read(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.texts = ""
        self.attributes: dict[str, str | None] = {}
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes |= dict(attrs)

    def handle_data(self, data: str) -> None:
        self.texts += data


@given(st.text(max_size=40), st.text(max_size=40))
def test_no_text_becomes_an_element_or_leaves_its_attribute(text: str, value: str) -> None:
    made = element("p", text, element("b", text), text, title=value)
    read = Read(tostring(made, encoding="unicode", method="html"))
    assert read.tags == ["p", "b"] and read.texts == 3 * sanitize(text)
    assert read.attributes == {"title": sanitize(value)}


def test_names_of_attributes_and_numbers() -> None:
    made = element("circle", cx=1.234567, stroke_width=2, class_="heat", viewBox="0 0 1 1")
    assert made.attrib == {"cx": "1.2346", "stroke-width": "2", "class": "heat", "viewBox": "0 0 1 1"}


def test_a_table_has_its_numbers_on_the_right() -> None:
    text = tostring(table(["Robot", "Done"], [["<r>", "3"]]), encoding="unicode", method="html")
    assert (
        '<th>Robot</th><th class="n">Done</th>' in text and '<td>&lt;r&gt;</td><td class="n">3</td>' in text
    )
