"""Rows of runs: painted by their role, and only what changed is sent."""

from rich.style import Style
from textual.geometry import Region

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run
from fleet_tui.ui.widgets.runs_view import RunsView
from tests.support.widget_app import WidgetApp, text

TEXT, WARN = StyleRole.TEXT, StyleRole.WARN


def rows(*texts: str) -> list[list[Run]]:
    return [[(f"{one:<20}", TEXT)] for one in texts]


class Watched(RunsView):
    """Remembers the regions that it refreshes."""

    def __init__(self) -> None:
        super().__init__({TEXT: Style(color="red"), WARN: Style(color="blue")})
        self.regions: list[Region] = []

    def refresh(self, *regions: Region, **options: bool) -> "Watched":
        self.regions += regions
        super().refresh(*regions, **options)
        return self


async def test_only_rows_that_changed_are_painted_again() -> None:
    view = Watched()
    async with WidgetApp(view).run_test(size=(20, 3)):
        view.paint_rows(rows("one", "two", "three"))
        strips = list(view.strips)
        view.regions.clear()
        view.paint_rows(rows("one", "TWO", "three"))
        assert view.regions == [Region(0, 1, 20, 1)]
        assert [now is before for now, before in zip(view.strips, strips, strict=True)] == [True, False, True]
        assert [line.strip() for line in text(view)] == ["one", "TWO", "three"]


async def test_a_theme_changes_every_row_and_a_shorter_list_leaves_blank_ones() -> None:
    view = Watched()
    async with WidgetApp(view).run_test(size=(20, 3)):
        view.paint_rows([[("a" * 20, WARN)], *rows("b")])
        view.set_role_styles({WARN: Style(bold=True)})
        (segment,) = view.render_line(0)
        assert segment.style == Style(bold=True)
        assert text(view)[2] == " " * 20
        crop = view.render_lines(Region(1, 0, 3, 2))
        assert [strip.text for strip in crop] == ["aaa", "   "]


async def test_before_the_first_rows_it_has_the_background_of_the_theme() -> None:
    view = RunsView()
    async with WidgetApp(view).run_test(size=(20, 3)):
        (segment,) = view.render_line(1)
        assert segment.style is not None and segment.style.bgcolor == view.rich_style.bgcolor
        assert segment.style.bgcolor is not None
