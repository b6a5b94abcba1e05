"""Text is scrolled by lines, pages and the wheel, never beyond its ends."""

from textual import events
from textual.app import App, ComposeResult

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.text_view import TextView


class Reader(App[None]):
    """Ten lines in four rows."""

    CSS = "TextView { height: 4; width: 8; }"

    def __init__(self) -> None:
        super().__init__()
        self.positions: list[str] = []
        self.text = TextView(id="text", moved=self.positions.append)

    def compose(self) -> ComposeResult:
        yield self.text


def first(reader: Reader) -> str:
    return reader.text.render_line(0).text.strip()


async def test_text_is_scrolled_to_its_ends_and_no_further() -> None:
    reader = Reader()
    async with reader.run_test() as pilot:
        reader.text.show(lambda width: [((f"line {n}", StyleRole.TEXT),) for n in range(10)])
        assert (first(reader), reader.positions[-1]) == ("line 0", "1-4 of 10, PgUp PgDn")
        reader.text.move(reader.text.page)
        assert first(reader) == "line 4"
        reader.text.move(-1)
        assert first(reader) == "line 3"
        reader.text.move(2 * reader.text.page)
        assert (first(reader), reader.positions[-1]) == ("line 6", "7-10 of 10, PgUp PgDn")
        reader.text.move(-99)
        assert first(reader) == "line 0"
        await pilot._post_mouse_events([events.MouseScrollDown], "#text")
        assert first(reader) == "line 3"


async def test_short_text_has_no_position_and_blank_rows_below() -> None:
    reader = Reader()
    async with reader.run_test():
        reader.text.show(lambda width: [(("x" * width, StyleRole.TEXT),)])
        assert (first(reader), reader.positions[-1]) == ("x" * 8, "")
        assert reader.text.render_line(3).text == " " * 8
