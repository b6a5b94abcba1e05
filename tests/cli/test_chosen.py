"""`--url` and no configuration, through the command line: what is behind an address, or why nothing is."""

import http.server
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from fleet_tui.config.schema import Config
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.terminal.detect import IN_BROWSER
from tests.support.cli import asked, run
from tests.support.site_faults import PLANTS


@contextmanager
def web_server() -> Iterator[str]:
    """A web server that knows nothing of rosbridge."""
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), http.server.SimpleHTTPRequestHandler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"ws://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.mark.parametrize("before", [True, False])
async def test_status_of_a_site_never_seen(server: RosbridgeServer, tmp_path: Path, before: bool) -> None:
    option = ["--url", server.url]
    line = [*option, "status", "--json"] if before else ["status", "--json", *option]
    done = await run(tmp_path, *line)
    report = json.loads(done.out)
    assert (done.code, done.err, report["attention"]) == (0, "", [])
    assert [robot["name"] for robot in report["robots"]] == ["robot_0", "robot_1"]
    assert not server.bridge.services.calls


async def test_status_of_robots_with_nav2(nav2: RosbridgeServer, tmp_path: Path) -> None:
    done = await run(tmp_path, "status", "--url", nav2.url)
    assert done.code == 0 and "robot_0" in done.out


async def test_an_order_and_a_pause(server: RosbridgeServer, tmp_path: Path) -> None:
    done = await run(tmp_path, "order", "robot_0", "Base", "Consumidores", "--url", server.url)
    assert done.code == 0, done.err
    paused = await run(tmp_path, "pause", "--all", "--url", server.url)
    assert paused.code == 0, paused.err
    assert sorted(asked(server)) == ["robot_0 Execute_order", "robot_0 Pause", "robot_1 Pause"]


async def test_a_recording(server: RosbridgeServer, tmp_path: Path) -> None:
    done = await run(tmp_path, "record", "it.jsonl.gz", "--for", "1s", "--url", server.url)
    assert done.code == 0, done.err
    assert (tmp_path / "it.jsonl.gz").stat().st_size > 1000


async def test_a_config_and_an_address_are_two_fleets(server: RosbridgeServer, tmp_path: Path) -> None:
    (tmp_path / "c.toml").write_text('[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n')
    for line in (
        ["status", "--url", server.url, "--config", "c.toml"],
        ["--config", "c.toml", "pause", "--all", "--url", server.url],
        ["serve", "--url", server.url, "--config", "c.toml"],
        ["--config", "c.toml", server.url],
    ):
        done = await run(tmp_path, *line)
        assert (done.code, done.out) == (2, "") and "--config and --url exclude each other" in done.err, line
    assert not server.bridge.received


@pytest.mark.parametrize(
    ("address", "code", "words"),
    [
        (
            "http://robot:9090",
            2,
            "http://robot:9090 is not a rosbridge address: did you mean ws://robot:9090?",
        ),
        ("https://robot/x", 2, "did you mean wss://robot/x?"),
        ("robot:9090", 2, "robot:9090 is not a rosbridge address: did you mean ws://robot:9090?"),
        ("localhost", 2, "localhost is not a rosbridge address: did you mean ws://localhost:9090?"),
        ("mqtt://robot:1883/topic", 2, "has a path: a broker has none, remove it"),
        ("mqtts://ana:secret@robot", 2, "set user_file and password_file to private files"),
        ("mqtt://127.0.0.1:9", 3, "connection refused"),
        ("ftp://robot", 2, "is not an address, expected e.g. ws://HOST:9090"),
        ("ws://", 2, "is not an address, expected e.g. ws://HOST:9090"),
        ("ws://user:secret@robot:9090", 2, "set authorization_file"),
        ("ws://127.0.0.1:9", 3, "connection refused: start rosbridge on it"),
        ("ws://robot.invalid:9090", 3, "correct the address, or the name in DNS"),
    ],
)
async def test_an_address_that_leads_nowhere(tmp_path: Path, address: str, code: int, words: str) -> None:
    done = await run(tmp_path, "status", "--url", address)
    assert (done.code, done.out) == (code, "") and words in done.err, done.err
    assert len(done.err.splitlines()) == 1 and "secret" not in done.err


@pytest.mark.parametrize("address", ["http://robot:9090", "robot:9090", "mqtt://robot/x", "ws://"])
async def test_the_console_refuses_such_an_address_before_it_opens(tmp_path: Path, address: str) -> None:
    plain = await run(tmp_path, address)
    assert plain.code == 2 and plain == await run(tmp_path, "--url", address)
    assert plain == await run(tmp_path, "--drawing", "ascii", address)


async def test_a_web_server(tmp_path: Path) -> None:
    with web_server() as url:
        done = await run(tmp_path, "status", "--url", url)
        assert (done.code, done.out) == (3, "")
        assert "web server, not rosbridge" in done.err and "usually listens on 9090" in done.err
        doctor = await run(tmp_path, "doctor", "--url", url)
        assert doctor.code == 3 and "web server, not rosbridge" in doctor.out


@pytest.mark.parametrize(
    ("plant", "words"),
    [("no rosapi", "start rosapi beside rosbridge"), ("a frozen rosapi", "restart rosapi (")],
)
async def test_a_bridge_that_does_not_tell(
    server: RosbridgeServer, tmp_path: Path, plant: str, words: str
) -> None:
    PLANTS[plant](server, Config())
    done = await run(tmp_path, "status", "--url", server.url)
    assert (done.code, done.out) == (1, "") and words in done.err
    doctor = await run(tmp_path, "doctor", "--url", server.url)
    assert doctor.code == 1 and words in doctor.out
    assert "rosbridge robots: " in doctor.out and "reply to a call in" in doctor.out


async def test_a_bridge_on_which_no_robot_is(server: RosbridgeServer, tmp_path: Path) -> None:
    for name in [name for name in server.bridge.services.types if name.startswith("/robot_")]:
        del server.bridge.services.types[name]
    done = await run(tmp_path, "status", "--url", server.url)
    assert (done.code, done.out) == (1, "") and "no robot found among" in done.err
    assert "start the robot nodes" in done.err
    doctor = await run(tmp_path, "doctor", "--url", server.url)
    assert doctor.code == 1 and "no robot found among" in doctor.out


async def test_the_doctor_of_a_site_never_seen(server: RosbridgeServer, tmp_path: Path) -> None:
    done = await run(tmp_path, "doctor", "--url", server.url)
    assert done.code == 0 and "robot_1 pose" in done.out, done.out
    dead = await run(tmp_path, "doctor", "--url", "ws://127.0.0.1:9", "--json")
    first = json.loads(dead.out)["first"]
    assert (dead.code, first["check"]) == (3, "tcp") and "correct the address" in first["remedy"]


async def test_robots_of_no_certain_kind_are_not_commanded_unseen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    both: list[Fleet] = [OhFleet(robots=1, floors=1, seed=1, quiet=True), Nav2Fleet(1, 1, seed=1, quiet=True)]
    server = RosbridgeServer(both, dialect=ROS2)
    await server.start()
    done = await run(tmp_path, "pause", "robot_0", "--url", server.url)
    assert done.code == 2 and "kind of robot_0: oh_ressources, possibly nav2" in done.err
    seen = await run(tmp_path, "status", "--url", server.url)
    assert "warning: kind of robot_0: oh_ressources, possibly nav2" in seen.err and "robot_0" in seen.out
    monkeypatch.setenv(IN_BROWSER, "textual.drivers.web_driver:WebDriver")
    tab = await run(tmp_path, server.url)
    assert tab.code == 2 and "kind of robot_0: oh_ressources, possibly nav2" in tab.err
    assert not server.bridge.services.calls
    await server.stop()


NEEDS_ONE = [
    *(["status"], ["order", "robot_0", "A", "B"], ["cancel", "robot_0", "1"], ["clear", "robot_0"]),
    *(["pause", "--all"], ["resume", "--all"], ["doctor"], ["record", "x.gz"], ["serve"], ["check"]),
    *(["config", "show"], ["run", "-"]),
]


@pytest.mark.parametrize("line", NEEDS_ONE, ids=" ".join)
async def test_without_a_configuration_nothing_is_invented(tmp_path: Path, line: list[str]) -> None:
    done = await run(tmp_path, *line, stdin="")
    assert (done.code, done.out) == (2, "")
    assert f"no ./config.toml, no {tmp_path}/fleet-tui/config.toml" in done.err
    assert "$FLEET_TUI_CONFIG is not set" in done.err and "--url ws://HOST:9090" in done.err


@pytest.mark.parametrize("line", [["kinds"], ["audit"], ["config", "init"], ["sim", "--help"]], ids=" ".join)
async def test_what_needs_no_configuration(tmp_path: Path, line: list[str]) -> None:
    assert (await run(tmp_path, *line)).code == 0


async def test_an_empty_address_is_none(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text('[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n')
    for line in (["pause", "--all", "--url", ""], ["--url", ""], ["--url="]):
        done = await run(tmp_path, *line)
        assert done.code == 2 and "empty address" in done.err, done.err


async def test_check_has_no_use_for_an_address(tmp_path: Path) -> None:
    done = await run(tmp_path, "--url", "ws://robot:9090", "check")
    assert done.code == 2 and "--url is not an option of check" in done.err
