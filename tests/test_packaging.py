"""The program carries its themes and default config: from a wheel, editable, and as a module."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from fleet_tui import __version__
from fleet_tui.config.load import shipped
from fleet_tui.ui.themes import load_themes

ROOT = Path(__file__).parent.parent
pytestmark = pytest.mark.one_fork
THEMES = {"dark", "light", "contrast", "colourblind"}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built wheel, unpacked."""
    folder = tmp_path_factory.mktemp("wheel")
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (built,) = folder.glob("*.whl")
    with zipfile.ZipFile(built) as archive:
        archive.extractall(folder / "site")
    return folder / "site"


def run(*args: str, site: Path, cwd: Path) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, "PYTHONPATH": str(site), "XDG_CONFIG_HOME": str(cwd)}
    env.pop("FLEET_TUI_CONFIG", None)
    return subprocess.run(
        [sys.executable, *args], cwd=cwd, env=env, capture_output=True, text=True, check=False
    )


def test_a_wheel_brings_its_own_config_and_themes(wheel: Path, tmp_path: Path) -> None:
    done = run("-m", "fleet_tui", "config", "init", site=wheel, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == (ROOT / "config.toml").read_text()
    code = "from fleet_tui.ui.themes import load_themes; print(*sorted(load_themes(None)[0]))"
    names = run("-c", code, site=wheel, cwd=tmp_path)
    assert set(names.stdout.split()) == THEMES
    assert (wheel / "fleet_tui" / "fleet.tcss").is_file()


def test_a_wheel_brings_its_languages(wheel: Path, tmp_path: Path) -> None:
    code = "from fleet_tui.ui.languages import use_language as use; from fleet_tui.text.language import tr"
    told = run("-c", f"{code}; use('de'); print(tr('no link'))", site=wheel, cwd=tmp_path)
    assert told.stdout == "keine Verbindung\n"


@pytest.mark.nightly
def test_a_wheel_brings_the_pages_of_the_documentation_without_pictures(wheel: Path, tmp_path: Path) -> None:
    done = run("-m", "fleet_tui", "docs", "security", site=wheel, cwd=tmp_path)
    assert done.stdout == (ROOT / "SECURITY.md").read_text()
    names = {path.name for path in (wheel / "fleet_tui" / "docs_shipped").iterdir()}
    assert names == {path.name for path in (ROOT / "docs").glob("*.md")} | {"security.md", "changelog.md"}


def test_a_checkout_finds_them_beside_the_package(tmp_path: Path) -> None:
    assert shipped() == ROOT / "config.toml"
    assert set(load_themes(None)[0]) == THEMES
    done = run("-m", "fleet_tui", "config", "init", site=ROOT, cwd=tmp_path)
    assert done.stdout == (ROOT / "config.toml").read_text()


def test_check_and_help_do_not_load_the_screen(tmp_path: Path) -> None:
    code = (
        "import sys\n"
        "from fleet_tui.__main__ import main\n"
        f"sys.argv = ['fleet-tui', 'check', {str(ROOT / 'config.toml')!r}]\n"
        "try:\n    main()\n"
        "finally:\n    print('loaded', [name for name in ('textual', 'roslibpy') if name in sys.modules])"
    )
    done = run("-c", code, site=ROOT, cwd=tmp_path)
    assert "loaded []" in done.stdout


def test_the_changelog_has_a_section_for_the_version() -> None:
    assert f"## [{__version__}]" in (ROOT / "CHANGELOG.md").read_text()
