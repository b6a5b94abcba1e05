"""The footer: keys laid out for its width, and anew when they change."""

from fleet_tui.keys import Pane
from fleet_tui.ui.widgets.key_line import KeyLine
from tests.support.kinds import KEYS
from tests.support.widget_app import WidgetApp, text


async def test_keys_follow_what_is_offered_and_the_width() -> None:
    line = KeyLine(KEYS, id="line")
    async with WidgetApp(line).run_test(size=(80, 3)) as pilot:
        line.offer(Pane.MAP, True, set(), "", "robot_7")
        assert text(line)[0].startswith(" o order") and "help" in text(line)[0]
        line.offer(Pane.MAP, False, set(), "alarms", "robot_7")
        assert text(line)[0].startswith(" a ack robot_7 ") and "o order" not in text(line)[0]
        await pilot.resize_terminal(30, 3)
        line.offer(Pane.MAP, False, set(), "alarms", "robot_7")
        assert len(text(line)[0]) == 30 and " a ack" in text(line)[0], "before the palette"
        assert " ? help" in text(line)[0]
