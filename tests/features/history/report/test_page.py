"""The page of a shift: in words what the pictures show, and nothing that runs."""

import re
from html.parser import HTMLParser

import pytest
from msgspec.structs import replace

from fleet_tui.features.history.report.axis import LocalTime
from fleet_tui.features.history.report.content import Claim, Handover, ReportContent
from fleet_tui.features.history.report.heat import FloorHeat
from fleet_tui.features.history.report.page import MOST_ROWS, page
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.history.facts import Activity, Note
from fleet_tui.model.history.lives import AlarmLife, PastCommand, PastOrder
from fleet_tui.model.history.totals import BlockedPlace, ChargeTotal
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.shift import AlarmCause, OrderCounts, RobotShift
from fleet_tui.text.language import Message

HOSTILE = "</p><script>alert(1)</script><img src=x onerror=alert(1)>"
TIME = Division(0.0, 28_800.0, 4)


def clock(at: float, is_long: bool) -> str:
    return f"{'d' if is_long else 't'}{at:.0f}"


def content(name: str = "robot_0") -> ReportContent:
    """A shift in which everything has a line."""
    counts = OrderCounts(
        done=20, late=3, lost=2, left=5, cancelled=1, timed=20, seconds=2000.0, longest=900.0
    )
    seconds = {Activity.DRIVING: 7200.0, Activity.BLOCKED: 600.0, Activity.OFFLINE: 120.0}
    return ReportContent(
        site=name,
        since=0.0,
        until=28_800.0,
        made_by="fleet-tui 1",
        begun=7200.0,
        unwatched="",
        notes=[Note(100.0, name, f"{name}: lift is slow")],
        robots=[RobotShift(name, counts, seconds, 21.0, 64.0)],
        routes={name: counts},
        handover=Handover(
            [
                PastOrder(name, "8", f"{name} -> B -> C", "f", 10.0, 20.0, None, "begun", "", name),
                PastOrder(name, "9", "-> D", "f", 30.0, None, None, "queued", "", ""),
            ],
            [AlarmLife(name, Message("offline"), "medium", name, 40.0, None, 50.0, None, name, 1)],
            [Claim(name, name, name)],
        ),
        causes=[AlarmCause(name, "high", 7, 2, 300.0, 90.0, 12.0)],
        outages={name: (2, 61.0)},
        losses=[PastOrder(name, "1", name, "f", 1.0, 2.0, 300.0, "lost", name, "")],
        refusals=[PastCommand(400.0, name, name, "pause", "", "refused", name)],
        time=TIME,
        timeline={name: [Activity.DRIVING, None, Activity.BLOCKED, None]},
        shares={},
        charges={name: [ChargeTotal(name, 0, 21.0, 64.0)]},
        floors=[FloorHeat(name, [BlockedPlace(name, 1.0, 1.0, 600.0)], MapFrame(0.05, 100, 100))],
        battery_low=20.0,
        local=LocalTime(0.0, clock, clock),
    )


class Text(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.lines: list[str] = []
        self.tags: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        assert not any(name.startswith("on") for name, _ in attrs)

    def handle_data(self, data: str) -> None:
        self.lines.append(data)


def test_the_next_shift_reads_its_notes_first() -> None:
    text = Text(page(content())).lines
    headings = ["Notes", "Orders and trouble", "Robots", "What the robots did"]
    places = [text.index(one) for one in headings]
    assert places == sorted(places) and "t100 robot_0: robot_0: lift is slow" in text


def test_what_goes_on_is_handed_over_by_name() -> None:
    text = "|".join(Text(page(content())).lines)
    assert "|robot_0|8|robot_0|C|begun|t20|robot_0|" in text
    assert "|robot_0|9|D|queued|t30|another client|" in text  # only queued, from where it is
    assert "|robot_0|offline|medium|robot_0|t40|holds|robot_0|" in text
    assert "|Handed over: claimed robots|Robot|By|Console|robot_0|robot_0|robot_0|" in text
    unknown = replace(content(), handover=Handover([], [], [], "/desk: gone"))
    text = "|".join(Text(page(unknown)).lines)
    assert "|No order is open.|" in text and "|No alarm is open.|" in text
    assert "|Claims unknown: /desk: gone|" in text and "No robot is claimed." not in text


def test_figures_are_in_words() -> None:
    text = "|".join(Text(page(content())).lines)
    assert "|20|done|3|of these late|2|lost or failed|5|left the queue|1|cancelled|2|still open|" in text
    assert "|7|alarms|12 min|downtime" in text
    assert "|robot_0|20|3|2|5|1|2 h|10 min|2 min|64 %|21 %|2 h|" in text
    assert "|robot_0|high|7|2|5 min|90 s|12 s|" in text  # the alarm
    assert "|robot_0|2|61 s|" in text  # the link
    assert "|t300|robot_0|robot_0|lost|robot_0|" in text
    assert "|t400|robot_0|robot_0|pause|refused|robot_0|" in text


def test_nothing_of_a_name_or_a_note_runs_or_is_fetched() -> None:
    made = page(content(HOSTILE))
    usual = Text(page(content()))
    read = Text(made)
    assert read.tags == usual.tags and "script" not in read.tags and "img" not in read.tags
    assert "default-src 'none'" in made
    assert re.findall(r"(?:src|href)=\"(?!data:)", made) == [] and "http" not in re.sub(
        "http-equiv", "", made
    )


def test_an_empty_shift_says_so() -> None:
    empty = replace(
        content(), notes=[], handover=Handover([], [], []), robots=[], routes={}, causes=[], outages={},
        losses=[], refusals=[], timeline={}, charges={}, floors=[], unwatched="nobody watches yet",
    )  # fmt: skip
    text = "|".join(Text(page(empty)).lines)
    for said in ("nobody watches yet", "No notes.", "No robot was seen.", "No order ended.", "No alarm."):
        assert said in text
    assert "Batteries" not in text and "No robot was blocked." in text


def test_days_have_shares_instead_of_single_activities() -> None:
    text = "|".join(Text(page(replace(content(), timeline={}, shares={"robot_0": [(0.5, 0.1)] * 4}))).lines)
    assert "Each column is 2 h: from below the part in which a robot was driving" in text


@pytest.mark.parametrize(("losses", "is_cut"), [(MOST_ROWS, False), (MOST_ROWS + 3, True)])
def test_a_long_list_is_cut_and_says_so(losses: int, is_cut: bool) -> None:
    usual = content()
    text = "|".join(Text(page(replace(usual, losses=list(usual.losses) * losses))).lines)
    assert text.count("|t300|") == MOST_ROWS and ("|and 3 more|" in text) is is_cut


def test_a_time_before_the_history_is_not_told_as_a_quiet_one() -> None:
    assert "Nobody watched before" in page(content())
    assert "Nobody watched before" not in page(replace(content(), begun=None))
