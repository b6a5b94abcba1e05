"""What is installed and released: from files with known hashes, of versions without known advisories."""

import hashlib
import json
import re
import subprocess
from pathlib import Path

import pytest

from fleet_tui import __version__
from release.advisories import findings, floors
from release.build import record
from release.locked import LOCK, ROOT, locked, normal, pins, versions

PROJECT = (ROOT / "pyproject.toml").read_text()


def number(version: str) -> tuple[int, ...]:
    return tuple(map(int, re.findall(r"\d+", version)))


def test_each_package_of_the_lock_has_hashes_and_the_lock_no_address() -> None:
    text = LOCK.read_text()
    assert len(versions(text)) == text.count("==") > 80
    assert all("--hash=sha256:" in lines for lines in pins(text).values())
    assert "://" not in text


def test_the_environment_is_installed_by_these_hashes() -> None:
    assert "--require-hashes -r requirements.lock" in (ROOT / "Makefile").read_text()


def test_the_lock_keeps_to_the_floors() -> None:
    tested = dict(pin.split("==") for pin in map(normal_pin, versions(LOCK.read_text())))
    lowest = dict(floor.split("==") for floor in map(normal_pin, floors(PROJECT)))
    assert len(lowest) > 30
    assert [name for name in lowest.keys() & tested if number(tested[name]) < number(lowest[name])] == []


def normal_pin(pin: str) -> str:
    name, version = pin.split("==")
    return f"{normal(name)}=={version}"


def test_a_part_of_the_lock_has_its_hashes() -> None:
    part = locked(["PyYAML", "zope_interface"])
    assert list(pins(part)) == ["pyyaml", "zope-interface"] and part.count("--hash=") > 2
    with pytest.raises(KeyError):
        locked(["unknown"])


def test_the_floor_of_the_web_server_has_the_repairs_of_its_advisories() -> None:
    lowest = dict(floor.split("==") for floor in floors(PROJECT))
    assert number(lowest["aiohttp"]) >= (3, 13, 4)


def test_an_advisory_is_told_with_its_remedy_and_what_was_not_checked() -> None:
    audited = {
        "dependencies": [
            {"name": "aiohttp", "version": "3.10", "vulns": [{"id": "CVE-1", "fix_versions": ["3.13.4"]}]},
            {"name": "rich", "version": "14", "vulns": []},
            {"name": "pyte", "skip_reason": "not found"},
        ]
    }
    assert list(findings("floor", json.dumps(audited))) == [
        "floor: aiohttp 3.10 has CVE-1: fixed in 3.13.4",
        "floor: 1 of 3 packages not checked",
    ]


def test_what_is_built_has_checksums_and_a_record(tmp_path: Path) -> None:
    wheel = tmp_path / "fleet_tui.whl"
    wheel.write_bytes(b"wheel")
    record([wheel], __version__, ["rich==15.0.0"], tmp_path)
    check = ["sha256sum", "--check", "--status", "SHA256SUMS"]
    assert subprocess.run(check, cwd=tmp_path, check=False).returncode == 0
    (told,) = tmp_path.glob("*.build.json")
    built = json.loads(told.read_text())
    assert built["files"] == {"fleet_tui.whl": hashlib.sha256(b"wheel").hexdigest()}
    assert built["lock"] == hashlib.sha256(LOCK.read_bytes()).hexdigest()
    assert built["packages"] == ["rich==15.0.0"] and built["version"] == __version__
    wheel.write_bytes(b"another")
    assert subprocess.run(check, cwd=tmp_path, check=False).returncode == 1
