"""Records of sessions that are no records."""

from pathlib import Path

import pytest

from fleet_tui.model.programs.program import ProgramState
from fleet_tui.programs.session_state import exit_text, session_status, stop_session


@pytest.mark.parametrize("content", [b"", b"{", b"\xff" * 300, b'{"pid": "x"}', b"[1, 2]"])
def test_what_is_no_record_is_stopped(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "job.session").write_bytes(content)
    assert session_status(tmp_path, "job", 0.0).state is ProgramState.STOPPED
    assert stop_session(tmp_path, "job") == "is not running"


def test_exit_codes_in_words() -> None:
    assert (exit_text(2), exit_text(-9)) == ("exit status 2", "killed by signal 9")
