"""A configuration is read whole, or refused with every problem at once."""

from collections.abc import Callable
from pathlib import Path

import pytest

from fleet_tui.config.load import find, load, load_if_any, shipped
from fleet_tui.config.start import initial_state
from fleet_tui.text.errors import ConfigError, NoConfigError
from tests.support.adapters import names_of

ENOUGH = """
[rosbridge]
url = "ws://127.0.0.1:9090"

[[floors]]
name = "floor_0"
# map = "maps/floor_0.yaml"   # map_server YAML, or a plain PNG/PGM
# frame_id = "map_0"          # where the pose's frame_id is not the floor's name

[[robots]]
name = "robot_0"
# floors = ["floor_0"]        # default: every floor
# size = [0.9, 0.6]           # length, width in metres
"""
# Every table that the operator's page names, every key that is there today.
FULL = """
[rosbridge]
url = "wss://site-a.example:443/bridge"
[links.site_b]
url = "ws://[::1]:9090"
[[floors]]
name = "floor_0"
map = "maps/floor_0.yaml"
frame_id = "/map_0"
[[floors]]
name = "floor_1"
[[robots]]
name = "robot_0"
floors = ["floor_0"]
size = [0.9, 0.6]
[[robots]]
name = "robot_1"
link = "site_b"
[operator]
name = "ana"
read_only = true
armed = false
[keys]
order = "O"
palette = ":,ctrl+p"
[ui]
theme = "light"
drawing = "half-block"
ticks_per_second = 5
pose_ms = 200
status_ms = 1000
[alarms]
offline_after = 10
obstacle_after = 1.5
battery_low = 30
battery_critical = 15
no_link_after = 4
no_answer_after = 8
[profile]
name = "oh_ressources"
refusals = ["(?i)nope"]
directed = true
origin = "added"
[profile.topics]
pose = "/{robot}/amcl_pose"
[profile.types]
battery = "std_msgs/Float64"
[profile.services]
pause = "/{robot}/halt"
[profile.fields]
"vertex.id" = "vid"
[profile.vertex_types]
lift = "elevator"
"""

Write = Callable[[str], Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def written(text: str) -> Path:
        path = tmp_path / "config.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return written


def problems(path: Path) -> list[str]:
    with pytest.raises(ConfigError) as caught:
        load(path)
    assert all(line.startswith(f"{path}: ") for line in caught.value.problems)
    return [line.removeprefix(f"{path}: ") for line in caught.value.problems]


def test_little_is_enough(write: Write) -> None:
    config = load(write(ENOUGH))
    assert [robot.name for robot in config.robots] == ["robot_0"]
    assert config.floors_of(config.robots[0]) == ["floor_0"]
    assert (config.alarms.offline_after, config.alarms.no_answer_after, config.ui.theme) == (5.0, 5.0, "dark")
    assert config.path.is_absolute()


def test_even_the_bridge_may_be_left_out(write: Write) -> None:
    config = load(write('[[floors]]\nname = "a"\n[[robots]]\nname = "b"\n'))
    assert config.rosbridge.url == "ws://127.0.0.1:9090"


def test_the_shipped_config_is_fine() -> None:
    assert load(shipped()).robots


def test_every_table_is_taken(write: Write) -> None:
    config = load(write(FULL))
    assert {name: link.url for name, link in config.bridges.items()} == {
        "rosbridge": "wss://site-a.example:443/bridge",
        "site_b": "ws://[::1]:9090",
    }
    assert config.floors[0].frame == "map_0"
    assert config.robots[0].size == (0.9, 0.6)
    assert (config.operator.read_only, config.operator.armed) == (True, False)
    assert (config.ui.drawing, config.ui.ticks_per_second) == ("half-block", 5.0)
    assert names_of(config.profile).topic("pose", "robot_1") == "/robot_1/amcl_pose"
    state = initial_state(config, 7.0)
    assert list(state.robots["robot_0"].maps) == ["floor_0"]
    assert list(state.robots["robot_1"].maps) == ["floor_0", "floor_1"]
    assert (state.limits.offline_after, state.limits.battery_low, state.limits.link_after) == (
        10.0,
        30.0,
        4.0,
    )
    assert {link.since for link in state.links.values()} == {7.0}


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("[rosbrige]\n", "rosbrige: unknown key, did you mean rosbridge?"),
        ("[rosbridge]\nurll = 'ws://a'\n", "rosbridge.urll: unknown key, did you mean url?"),
        ("[alarms]\noffline_aftr = 3\n", "alarms.offline_aftr: unknown key, did you mean offline_after?"),
        ("[links.b]\nuri = 'ws://a'\n", "links.b.uri: unknown key, did you mean url?"),
        ("[operator]\nqqqqqq = 1\n", "operator.qqqqqq: unknown key"),
        ("path = 'x'\n", "path: unknown key"),
        ("[ui]\nticks_per_second = 'ten'\n", "ui.ticks_per_second: expected a number, got text"),
        ("[ui]\npose_ms = 0.5\n", "ui.pose_ms: expected a whole number, got a number"),
        ("[ui]\nlanguage = 'fr'\n", "ui.language: 'fr' is not one of en, pt, de"),
        (
            "[ui]\ndrawing = 'brail'\n",
            "'brail' is not one of auto, braille, half-block, ascii, did you mean braille?",
        ),
        ("[operator]\nread_only = 1\n", "operator.read_only: expected true or false, got a whole number"),
        ("[alarms]\noffline_after = 0\n", "alarms.offline_after: expected a number > 0"),
        ("[alarms]\noffline_after = nan\n", "alarms.offline_after: expected a number > 0"),
        ("[alarms]\nclear_after = -1\n", "alarms.clear_after: expected a number >= 0"),
        ('[alarms]\nbell = "high"\n', "alarms.bell: expected a list, got text"),
        ("[alarms]\nbattery_low = 120\n", "alarms.battery_low: expected a number <= 100"),
        ("rosbridge = 'ws://a'\n", "rosbridge: must be a table"),
        ("[links]\nb = 1\n", "links.b: must be a table"),
        ("[keys]\norder = 1\n", "keys.order: expected text"),
        ("[profile]\norigin = 'rosy'\n", "'rosy' is not one of ros, added, did you mean ros?"),
        ("[profile.vertex_types]\nlift = 'elevater'\n", "did you mean elevator?"),
    ],
)
def test_each_kind_of_problem_is_named_with_its_key(write: Write, text: str, line: str) -> None:
    (found,) = problems(write(text + ENOUGH.replace("[rosbridge]\n", "").replace('url = "ws', '# "')))
    assert line in found


def test_rows_are_counted_and_what_is_missing_is_said(write: Write) -> None:
    found = problems(write(ENOUGH + "[[robots]]\nnme = 'r'\nsize = [1.0]\n[[robots]]\n"))
    assert "robots[1].nme: unknown key, did you mean name?" in found
    assert "robots[1].name: missing" in found
    assert "robots[2].name: missing" in found
    assert any(line.startswith("robots[1].size: ") for line in found)


def test_all_problems_come_at_once(write: Write) -> None:
    text = FULL.replace("wss:", "http:").replace("half-block", "halfblock").replace('"site_b"', '"site_c"')
    text = text.replace("no_link_after", "no_link_aftr").replace('order = "O"', 'ordr = "O"')
    found = problems(write(text.replace('["floor_0"]', '["flor_0"]')))
    wanted = [
        "rosbridge.url",
        "ui.drawing",
        "robots[1].link",
        "alarms.no_link_aftr",
        "keys.ordr",
        "robots[0].floors",
    ]
    assert sorted(line.partition(":")[0] for line in found) == sorted(wanted)
    assert sum("did you mean" in line for line in found) == 5


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"[robots\n", "not TOML"),
        (b"a = 1\na = 2\n", "not TOML"),
        (b"a = " + b"9" * 5000, "not TOML"),
        (b"a = " + b"[" * 2000 + b"]" * 2000, "not TOML"),
        (b"name = '\xff'\n", "not UTF-8 text: save it as UTF-8"),
        ("# a\nname = “x”\n".encode(), "(at line 2, column 8); this is the quote of a text processor"),
        ("[[robots]]\n\u00a0name = 'x'\n".encode(), "this is a no-break space: write a usual one"),
        ("# “quoted”\nname = M’bala\n".encode(), "(at line 2, column 8)"),
        (b'[{"name": 1}]\n', "this is JSON: write key = value below [table]"),
        (b"---\nrosbridge:\n", "this is YAML: write key = value below [table]"),
        (b'{"rosbridge": {}}\n', "this is JSON: write key = value below [table]"),
        (b"# a\nrosbridge:\n  url: x\n", "this is YAML: write key = value below [table]"),
        (b"", "robots: empty"),
    ],
)
def test_what_is_no_config_at_all(tmp_path: Path, content: bytes, says: str) -> None:
    path = tmp_path / "config.toml"
    path.write_bytes(content)
    assert any(says in line for line in problems(path))


def test_a_file_of_windows_is_one(tmp_path: Path) -> None:
    path = tmp_path / "config.toml"
    path.write_bytes(b'\xef\xbb\xbf[[floors]]\r\nname = "f"\r\n[[robots]]\r\nname = "r"\r\n')
    assert [robot.name for robot in load(path).robots] == ["r"]


def test_a_file_that_cannot_be_read(tmp_path: Path) -> None:
    assert problems(tmp_path / "none.toml") == [
        f"no such file: fleet-tui config init --output {tmp_path / 'none.toml'} writes one"
    ]
    assert problems(tmp_path)[0].startswith("unreadable")


def test_which_config_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "home"))
    monkeypatch.delenv("FLEET_TUI_CONFIG", raising=False)
    with pytest.raises(NoConfigError, match=r"(?s)no configuration found.* no ./config.toml, no .*--url"):
        find(None)
    assert load_if_any(None).robots == []
    own = tmp_path / "home" / "fleet-tui" / "config.toml"
    own.parent.mkdir(parents=True)
    own.touch()
    assert find(None) == own
    (tmp_path / "config.toml").touch()
    assert find(None) == Path("config.toml")
    monkeypatch.setenv("FLEET_TUI_CONFIG", "env.toml")
    with pytest.raises(ConfigError, match=r"\$FLEET_TUI_CONFIG names env.toml: no such file"):
        find(None)
    (tmp_path / "env.toml").touch()
    assert find(None) == Path("env.toml")
    assert find("given.toml") == Path("given.toml")
    assert find("~no-such-user-here/x.toml") == Path("~no-such-user-here/x.toml")


@pytest.mark.parametrize("seconds", ["0", "-1", "nan", "inf", "60", '"0.5"'])
def test_a_robot_that_drives_on_for_long_has_no_timeout(tmp_path: Path, seconds: str) -> None:
    path = tmp_path / "config.toml"
    path.write_text(f"{ENOUGH}\n[drive]\nrobot_timeout = {seconds}\n")
    with pytest.raises(ConfigError, match=r"drive\.robot_timeout: expected a number"):
        load(path)


def test_a_demo_takes_a_configuration_without_robots_and_floors(tmp_path: Path) -> None:
    file = tmp_path / "config.toml"
    file.write_text('[ui]\nlanguage = "pt"\n')
    assert load_if_any(str(file)).ui.language == "pt"
    with pytest.raises(ConfigError, match="robots: empty"):
        load(file)
    file.write_text('[ui]\nlanguage = "pt"\ncolour = 3\n')
    with pytest.raises(ConfigError, match=r"ui\.colour"):
        load_if_any(str(file))
