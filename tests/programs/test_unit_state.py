"""Units as `systemctl show` prints them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.programs.program import ProgramState
from fleet_tui.programs.status import MOST_DEPENDENTS, unit_status

RUNNING = """Result=success
ExecMainStatus=0
NRestarts=3
LoadState=loaded
ActiveState=active
SubState=running
StateChangeTimestamp=Mon 2024-05-06 08:00:00 UTC
InvocationID=c0ffee
RequiredBy=nav2.service other.service
BoundBy=nav2.service
"""


def test_a_unit_that_runs() -> None:
    found = unit_status(RUNNING, "u", 7.0)
    assert found is not None
    assert (found.state, found.at, found.since) == (ProgramState.RUNNING, 7.0, 1714982400.0)
    assert (found.restarts, found.instance, found.detail) == (3, "c0ffee", "")
    assert found.dependents == ("nav2.service", "other.service")


@pytest.mark.parametrize(
    ("lines", "state", "detail"),
    [
        ("ActiveState=failed\nResult=exit-code\nExecMainStatus=3", ProgramState.FAILED, "exit status 3"),
        ("ActiveState=failed\nResult=signal\nExecMainStatus=9", ProgramState.FAILED, "killed by signal 9"),
        ("ActiveState=failed\nResult=oom-kill", ProgramState.FAILED, "killed for lack of memory"),
        ("ActiveState=failed\nResult={0.x}", ProgramState.FAILED, "{0.x}"),
        ("ActiveState=activating\nSubState=auto-restart", ProgramState.STARTING, "auto-restart"),
        ("ActiveState=deactivating", ProgramState.STOPPING, ""),
        ("ActiveState=inactive\nLoadState=masked", ProgramState.STOPPED, "its unit file is masked"),
        ("ActiveState=inactive\nLoadState=not-found", ProgramState.UNKNOWN, "no unit u: check its name"),
    ],
)
def test_other_states_and_their_reasons(lines: str, state: ProgramState, detail: str) -> None:
    found = unit_status(lines, "u", 0.0)
    assert found is not None and found.state is state and found.detail.startswith(detail)


@pytest.mark.parametrize("date", ["9999-12-31", "0001-01-01"])
def test_a_time_at_the_end_of_the_calendar_has_no_local_time(date: str) -> None:
    found = unit_status(f"ActiveState=active\nStateChangeTimestamp=Mon {date} 12:00:00 UTC", "u", 0.0)
    assert found is not None and found.since is None


def test_other_output_is_no_state() -> None:
    assert unit_status("Failed to connect to bus", "u", 0.0) is None
    assert unit_status("ActiveState=undead", "u", 0.0) is None


@given(st.text())
def test_any_text_is_survived_and_bounded(text: str) -> None:
    found = unit_status(f"ActiveState=active\nRequiredBy={text}\nStateChangeTimestamp={text}", "u", 0.0)
    assert found is None or len(found.dependents) <= MOST_DEPENDENTS
