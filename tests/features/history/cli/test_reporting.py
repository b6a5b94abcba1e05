"""`fleet-tui report`: a file that is whole, and what stands in it."""

import re
from pathlib import Path

import msgspec
import pytest

from fleet_tui.model.history.facts import OrderChange
from fleet_tui.records.desk.presence import Presence
from tests.support.browser import CHROMIUM, browser
from tests.support.command_line import run
from tests.support.routine_files import ONE_ROBOT
from tests.support.shift import HOSTILE, an_hour_ago, shift, written


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "depot"
    folder.mkdir()
    (folder / "map.pgm").write_bytes(b"P5\n40 40\n255\n" + bytes([0, 255] * 800))
    (folder / "map.yaml").write_text(
        "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.2\n"
    )
    (folder / "config.toml").write_text(
        ONE_ROBOT.replace('name = "f"', 'name = "floor_0"\nmap = "map.yaml"', 1)
    )
    written(folder, shift(an_hour_ago()))
    return folder


def test_a_shift_on_one_page(site: Path) -> None:
    done = run("report", "--since", "2h", "--output", "shift.html", cwd=site)
    text = (site / "shift.html").read_text()
    assert done.returncode == 0 and done.stdout.startswith("shift.html: ") and done.stderr == ""
    assert "<h1>depot</h1>" in text and "nobody watches since" in text
    assert "data:image/png;base64," in text and "left the queue" in text
    assert "<script" not in text and "&lt;script&gt;" in text and "\x1b" not in text


def test_what_goes_on_is_handed_over_with_the_claims_of_the_desk(site: Path) -> None:
    (site / "desk").mkdir()
    config = site / "config.toml"
    config.write_text(f'{config.read_text()}\n[desk]\nfolder = "desk"\n')
    written(site, [OrderChange("robot_0", "9", "Dock -> Hall", an_hour_ago(), "queued", "floor_0")])
    claims = Presence("pc-1-ab", "eva", "pc", "another boot", claims=("robot_0", "robot_of_yesterday"))
    (site / "desk" / "console-pc-1-ab.json").write_bytes(msgspec.json.encode(claims))
    assert run("report", "--since", "2h", "--output", "shift.html", cwd=site).returncode == 0
    text = " ".join(re.sub("<[^>]*>", " ", (site / "shift.html").read_text()).split())
    assert "robot_0 9 Dock Hall queued" in text and "robot_0 eva pc" in text
    assert "robot_of_yesterday" not in text
    (site / "desk").rename(site / "gone")
    assert run("report", "--since", "2h", "--output", "shift.html", cwd=site).returncode == 0
    assert "No such file or directory" in (site / "shift.html").read_text()


def test_an_older_one_is_replaced_and_a_bad_place_is_named(site: Path) -> None:
    (site / "shift.html").write_text("old")
    assert run("report", "--output", "shift.html", cwd=site).returncode == 0
    assert "old" not in (site / "shift.html").read_text()[:100]
    done = run("report", "--output", "no/shift.html", cwd=site)
    assert (done.returncode, done.stdout) == (1, "") and "no/shift.html: No such file" in done.stderr
    assert run("report", cwd=site).returncode == 2


@pytest.mark.skipif(CHROMIUM is None, reason="no chromium is installed")
async def test_in_a_browser_nothing_of_it_runs_and_its_pictures_are_seen(site: Path) -> None:
    assert run("report", "--since", "2h", "--output", "shift.html", cwd=site).returncode == 0
    async with browser(site) as tab:
        await tab.go((site / "shift.html").as_uri())
        await tab.until_true("document.readyState === 'complete' && document.querySelector('h1')")
        assert (await tab.evaluate("document.title")).startswith("depot: ")
        assert await tab.evaluate("document.querySelectorAll('script').length") == 0
        told = await tab.evaluate("document.querySelector('.notes').innerText")
        assert HOSTILE.replace("\x1b", "␛") in told
        widths = "[...document.querySelectorAll('svg')].map(one => one.getBoundingClientRect())"
        assert await tab.evaluate(f"{widths}.every(one => one.width > 10 && one.height > 5)")
        assert await tab.evaluate("document.querySelectorAll('circle').length") == 1
        assert await tab.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
        assert {url.split(":")[0] for url in tab.asked} <= {"file", "data"} and tab.errors == []
