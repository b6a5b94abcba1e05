"""Alarms of this session that are over, as the log tells them."""

from collections.abc import Iterator

from msgspec.structs import replace

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.past_alarms import past_alarms
from tests.support.records import record

RUN = "now"


def at(minute: int, **fields: str) -> AuditRecord:
    return replace(record("r"), time=f"2026-05-31T12:{minute:02}:00.000+02:00", **{"run": RUN, **fields})


def alarm(minute: int, change: str, what: str = "battery", **fields: str) -> AuditRecord:
    return at(minute, kind="alarm", what=what, change=change, words=f"{what} low", **fields)


def opened(minute: int) -> AuditRecord:
    return at(minute, kind="console", what="console", change="opened", robot="")


def found(*oldest_first: AuditRecord, most: int = 5) -> list[tuple[str, str, str]]:
    past = past_alarms(reversed(oldest_first), RUN, "robot_0", most)
    return [(one.text, one.began, one.ended) for one in past]


def test_an_alarm_that_is_over_is_told_with_its_begin_and_end() -> None:
    log = [opened(0), alarm(1, "raised"), alarm(3, "returned"), alarm(9, "acknowledged, cleared")]
    assert found(*log) == [("battery low", "12:01:00", "12:03:00")]


def test_one_that_holds_is_none_of_them() -> None:
    assert found(opened(0), alarm(1, "raised"), alarm(2, "acknowledged")) == []
    log = [opened(0), alarm(1, "raised"), alarm(2, "returned, cleared"), alarm(3, "raised")]
    assert found(*log) == [("battery low", "12:01:00", "12:02:00")]


def test_other_robots_other_runs_and_other_kinds_are_kept_apart() -> None:
    log = [
        *(
            opened(0),
            alarm(1, "raised"),
            alarm(1, "raised", what="offline"),
            alarm(1, "raised", robot="robot_1"),
        ),
        *(alarm(2, "cleared", run="other"), alarm(3, "cleared", what="offline")),
        alarm(4, "cleared", robot="robot_1"),
    ]
    assert found(*log) == [("offline low", "12:01:00", "12:03:00")]


def test_reading_ends_at_the_start_of_this_run_or_with_enough() -> None:
    def log() -> Iterator[AuditRecord]:
        yield from (
            alarm(4, "cleared"),
            alarm(3, "raised"),
            alarm(2, "cleared"),
            alarm(1, "raised"),
            opened(0),
        )
        raise AssertionError("read on")

    assert len(past_alarms(log(), RUN, "robot_0", 5)) == 2
    assert [one.began for one in past_alarms(log(), RUN, "robot_0", 1)] == ["12:03:00"]
