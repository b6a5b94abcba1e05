"""Questions name what goes with a program, and what it lacks."""

from msgspec.structs import replace

from fleet_tui.features.programs.questions import change_question
from fleet_tui.model.programs.program import ProgramRow, ProgramState, ProgramStatus

UP, DOWN = ProgramStatus(ProgramState.RUNNING), ProgramStatus(ProgramState.STOPPED)
ROWS = {
    "bridge": ProgramRow("bridge", "server", status=replace(UP, dependents=("a.service", "b.service"))),
    "nav": ProgramRow("nav", needs=("bridge",), status=UP),
    "map": ProgramRow("map", needs=("bridge", "nav"), status=DOWN),
}


def test_a_stop_names_the_units_and_programs_that_depend_on_it() -> None:
    assert change_question(ROWS, "bridge", "stop", 0.0).splitlines() == [
        "Stop bridge on server? It is running.",
        "systemd also stops a.service, b.service.",
        "nav needs it, and is running.",
    ]
    assert "systemd also restarts a.service" in change_question(ROWS, "bridge", "restart", 0.0)


def test_a_start_names_what_is_missing() -> None:
    rows = {**ROWS, "nav": replace(ROWS["nav"], status=DOWN)}
    assert change_question(rows, "map", "start", 0.0).splitlines() == [
        "Start map? It is stopped.",
        "It needs nav, which is stopped.",
    ]
