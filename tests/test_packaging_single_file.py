"""The single file: unpacked once, into a folder that can hold it, and every refusal is in words."""

import ast
import os
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from release.build import PYTHON, packed
from release.locked import ROOT

PROGRAM = """
import fleet_tui, sys
print(fleet_tui.__file__, sys.prefix, *sys.argv[1:])
"""


def content(folder: Path) -> Path:
    """A program as small as can be, where a release has the console."""
    package = folder / "lib" / f"python{PYTHON}" / "site-packages" / "fleet_tui"
    package.mkdir(parents=True)
    (package / "__init__.py").touch()
    (package / "__main__.py").write_text(PROGRAM)
    (package / "map.bin").write_bytes(os.urandom(100_000))
    return folder


@pytest.fixture
def single(tmp_path: Path) -> Path:
    return packed(content(tmp_path / "content"), "9.9", tmp_path)


def environment(place: Path, **more: str) -> dict[str, str]:
    usual = {"HOME": str(place / "home"), "TMPDIR": str(place / "temporary"), "PATH": os.environ["PATH"]}
    (place / "temporary").mkdir(exist_ok=True)
    return usual | more


def start(
    single: Path, limit: Callable[[], None] | None = None, **more: str
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(single), "kinds", "--json"],
        env=environment(single.parent, **more),
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=limit,
    )


def test_the_first_start_says_where_it_unpacks_and_the_next_says_nothing(single: Path) -> None:
    first, second = start(single), start(single)
    assert first.returncode == 0
    assert f"{single.parent}/home/.cache/fleet-tui/fleet-tui-9.9-" in first.stderr
    assert "SHIV_ROOT" in first.stderr
    assert first.stdout.startswith(f"{single.parent}/home/.cache/fleet-tui/")
    assert first.stdout.endswith(" kinds --json\n")
    assert (second.stdout, second.stderr) == (first.stdout, "")


def test_what_it_starts_does_not_see_what_is_packed(single: Path) -> None:
    (
        single.parent / "content" / "lib" / f"python{PYTHON}" / "site-packages" / "fleet_tui" / "__main__.py"
    ).write_text(
        "import os, sys, subprocess\n"
        "print([name for name in os.environ if name.startswith('PYTHON')])\n"
        "print(subprocess.run([sys.executable, '-c', 'import fleet_tui'], cwd='/').returncode)\n"
        "print(subprocess.run([sys._base_executable, '-Sc', 'import fleet_tui'], cwd='/').returncode)\n"
    )
    other = packed(single.parent / "content", "9.8", single.parent)
    assert start(other).stdout.split() == ["[]", "0", "1"]


def test_a_chosen_folder_is_the_only_one(single: Path) -> None:
    chosen = single.parent / "chosen"
    assert start(single, SHIV_ROOT=str(chosen)).stdout.startswith(f"{chosen}/fleet-tui-9.9-")
    done = start(single, SHIV_ROOT="/dev/null/chosen")
    assert (done.returncode, done.stdout) == (1, "")
    assert "cannot unpack" in done.stderr and "/dev/null/chosen: Not a directory" in done.stderr


def test_a_home_that_cannot_be_written_leaves_a_private_temporary_folder(single: Path) -> None:
    done = start(single, HOME="/dev/null")
    root = single.parent / "temporary" / f"fleet-tui-{os.getuid()}"
    assert done.returncode == 0 and done.stdout.startswith(f"{root}/")
    assert root.stat().st_mode & 0o077 == 0


@pytest.mark.skipif(os.getuid() != 0, reason="only root can give a folder to another user")
def test_a_temporary_folder_of_another_user_is_refused(single: Path) -> None:
    root = single.parent / "temporary" / f"fleet-tui-{os.getuid()}"
    root.mkdir(parents=True)
    os.chown(root, 12345, 12345)
    done = start(single, HOME="/dev/null")
    assert done.returncode == 1 and "belongs to another user" in done.stderr


def test_starts_at_the_same_time_all_run(single: Path) -> None:
    command, env = [sys.executable, str(single)], environment(single.parent)
    starts = [subprocess.Popen(command, env=env, stdout=subprocess.PIPE, text=True) for _ in range(5)]
    said = {one.communicate()[0] for one in starts}
    assert [one.returncode for one in starts] == [0] * 5
    assert len(said) == 1


def test_a_folder_without_space_is_named_and_left_as_it_was(single: Path) -> None:
    done = start(single, limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000)))
    assert (done.returncode, done.stdout) == (1, "")
    assert f"{single.parent}/home/.cache/fleet-tui: File too large" in done.stderr
    assert "SHIV_ROOT=FOLDER" in done.stderr and "Traceback" not in done.stderr
    assert list((single.parent / "home" / ".cache" / "fleet-tui").glob("*.new")) == []
    assert start(single).returncode == 0


def test_a_damaged_file_is_named(single: Path) -> None:
    whole = bytearray(single.read_bytes())
    whole[len(whole) // 2] ^= 0xFF
    single.write_bytes(whole)
    done = start(single)
    assert (done.returncode, done.stdout) == (1, "")
    assert f"{single} is damaged: copy it again" in done.stderr and "Traceback" not in done.stderr


def test_another_python_or_machine_is_refused_with_what_to_do(tmp_path: Path) -> None:
    other = packed(content(tmp_path / "content"), "9.9", tmp_path, python="3.99")
    done = start(other)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"needs Python 3.99 and was started by Python {PYTHON}" in done.stderr
    assert f"Start it with: python3.99 {other}" in done.stderr
    assert "without root by: uv python install 3.99" in done.stderr


def test_any_python_can_read_what_says_which_one_is_needed() -> None:
    ast.parse((ROOT / "release" / "pyz" / "__main__.py").read_text(), feature_version=(3, 4))


@pytest.mark.skipif(os.getuid() != 0, reason="only root can give a link to another user")
def test_a_link_of_another_user_in_the_temporary_folder_is_refused(single: Path) -> None:
    root = single.parent / "temporary" / f"fleet-tui-{os.getuid()}"
    root.parent.mkdir()
    root.symlink_to(single.parent)
    os.chown(root, 12345, 12345, follow_symlinks=False)
    done = start(single, HOME="/dev/null")
    assert done.returncode == 1 and "belongs to another user" in done.stderr
