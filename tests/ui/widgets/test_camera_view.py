"""A picture in the middle of its pane, its colours, and only what changed is painted."""

import numpy as np
import pytest
from rich.color import Color
from textual.geometry import Region

from fleet_tui.ui.view.camera.cells import half_blocks, ramp
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.camera_view import CameraView
from tests.support.widget_app import WidgetApp, text

PIXELS = np.array([[[255, 0, 0]], [[0, 0, 255]]], np.uint8)
TITLE = "Camera r1", StyleRole.TITLE


def shown_view() -> CameraView:
    view = CameraView()
    view.styles.display = "block"
    return view


async def test_a_picture_is_in_the_middle_in_its_two_colours() -> None:
    view = shown_view()
    async with WidgetApp(view).run_test(size=(15, 4)):
        assert view.space == (15, 6)
        view.show(TITLE, "", half_blocks(PIXELS))
        assert text(view) == ["─ Camera r1 ───", " " * 15, " " * 7 + "▀" + " " * 7, " " * 15]
        (cell,) = [part for part in view.render_line(2) if part.text == "▀"]
        assert cell.style is not None
        assert (cell.style.color, cell.style.bgcolor) == (Color.from_ansi(196), Color.from_ansi(21))
        view.show(TITLE, "", ramp(PIXELS), "-")
        assert text(view)[0] == "- Camera r1 ---" and text(view)[2].strip() == ""


async def test_without_a_picture_there_is_a_note(monkeypatch: pytest.MonkeyPatch) -> None:
    view = shown_view()
    async with WidgetApp(view).run_test(size=(12, 3)):
        view.show(TITLE, "waiting", None)
        assert text(view)[2] == "  waiting   "
        sent: list[Region] = []
        monkeypatch.setattr(view, "refresh", lambda *regions: sent.extend(regions))
        view.show(TITLE, "waiting", None)
        assert not sent
        view.show(("Camera r2", StyleRole.TITLE), "waiting", None)
        assert sent == [Region(0, 0, 12, 1)] and "r2" in text(view)[0]
        view.set_role_styles({})
        view.show(TITLE, "far too long for it", None)
        assert text(view)[1:] == ["far too long", "   for it   "], "a topic must be readable to its end"
