"""Commands that simulate robots: what they refuse, list and announce."""

import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from fleet_tui.console.simulate import simulated
from tests.support.command_line import run


def test_sim_prints_its_url_and_ends_with_130_on_ctrl_c(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "fleet_tui", "sim", "--port", "0"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
        assert child.stdout is not None
        assert child.stderr is not None
        assert child.stdout.readline().startswith(b"ws://127.0.0.1:")
        child.send_signal(signal.SIGINT)
        assert child.wait(10) == 130
        assert child.stderr.read() == b""


def test_a_port_in_use_is_named(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "fleet_tui", "sim", "--port", "0"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE) as child:
        assert child.stdout is not None
        port = child.stdout.readline().decode().strip().rpartition(":")[2]
        done = run("sim", "--port", port, cwd=tmp_path)
        child.terminate()
    assert done.returncode == 1
    assert port in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--kind", "mixed", "--robots", "3"], "all 4 kinds need at least --robots 4"),
        (["--kind", "mixed", "--ros", "1"], "--ros needs a single kind"),
        (["--kind", "mixed", "--port", "65534"], "--port 65533 is the maximum"),
        (["--kind", "nav2", "--ros", "1"], "kind nav2 runs on ROS 2 only"),
        (["--kind", "nav3"], "did you mean nav2?"),
        (["--graph-file", "x.geojson"], "robots of kind oh_ressources publish their graph"),
    ],
)
def test_what_such_robots_can_not_be_is_refused(options: list[str], words: str) -> None:
    found = CliRunner().invoke(simulated, ["sim", *options])
    assert found.exit_code == 2 and words in found.stderr


def test_a_graph_file_is_written_once_the_server_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "g.geojson"

    def run(
        robots: int, floors: int, _port: int, _rate: float, _seed: int, announce: Any, **_: object
    ) -> None:
        assert (robots, floors, path.exists()) == (4, 1, False)
        announce(["ws://a:1"])

    monkeypatch.setattr("fleet_tui.simulator.run.run", run)
    options = ["--kind", "nav2", "--robots", "4", "--floors", "1", "--graph-file", str(path)]
    found = CliRunner().invoke(simulated, ["sim", *options])
    assert (found.exit_code, found.stdout) == (0, "ws://a:1\n") and path.is_file()


def test_a_mixed_fleet_without_a_broker_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    served = list[Any]()
    monkeypatch.setattr("fleet_tui.simulator.run.run", lambda *_, **given: served.append(given["beside"]))
    monkeypatch.setattr("fleet_tui.simulator.vda5050.broker.has_broker", lambda: False)
    monkeypatch.setattr("fleet_tui.simulator.vda5050.serving.has_broker", lambda: False)
    found = CliRunner().invoke(simulated, ["sim", "--kind", "mixed"])
    assert found.exit_code == 0 and served == [None]
    assert "no broker for the vehicles: apt install mosquitto" in found.stderr
