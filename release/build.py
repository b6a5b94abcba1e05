"""Build what is released into dist/: the wheel, the sdist, and a single file that runs without either.

Run: python -m release.build, with the Python for which the single file is meant.
"""

import hashlib
import platform
import shutil
import subprocess
import sys
import zipapp
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
DIST = ROOT / "dist"
PYTHON = ".".join(map(str, sys.version_info[:2]))


def built() -> Path:
    """Build wheel and sdist, and return the wheel."""
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-d", str(DIST)], cwd=ROOT, check=True)
    return max(DIST.glob("*.whl"), key=lambda path: path.stat().st_mtime)


def installed(wheel: Path, site: Path) -> None:
    """Install the wheel with all that it needs, in the tested versions."""
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    tested = ["--constraint", str(ROOT / "requirements.lock")]
    subprocess.run([*pip, "--no-compile", *tested, "--target", str(site), f"{wheel}[serve,bags]"], check=True)
    # Scripts for the Python of this machine.
    shutil.rmtree(site / "bin", ignore_errors=True)


def packed(content: Path, version: str, to: Path = DIST, python: str = PYTHON) -> Path:
    """Pack a folder with `lib/` as one file that unpacks and starts it."""
    machine = platform.machine()
    target = to / f"fleet-tui-{version}-py{python.replace('.', '')}-{machine}.pyz"
    values = {"PYTHON": python, "MACHINE": machine, "NAME": f"{target.stem}-{_digest(content)}"}
    for source in (ROOT / "release" / "pyz").glob("*.py"):
        text = source.read_text(encoding="utf-8")
        for name, value in values.items():
            text = text.replace(f"@{name}@", value)
        (content / source.name).write_text(text, encoding="utf-8")
    target.unlink(missing_ok=True)  # it may be running
    zipapp.create_archive(content, target, "/usr/bin/env python3", compressed=True)
    target.chmod(0o755)
    return target


def _digest(content: Path) -> str:
    """Return a short digest of all files: another build is unpacked to another folder."""
    total = hashlib.sha256()
    for path in sorted(path for path in content.rglob("*") if path.is_file()):
        total.update(str(path.relative_to(content)).encode())
        total.update(path.read_bytes())
    return total.hexdigest()[:12]


def main() -> None:
    """Build all three and print their sizes."""
    wheel = built()
    version = wheel.name.split("-")[1]
    with TemporaryDirectory() as folder:
        content = Path(folder)
        print("Collecting what the single file needs ...", flush=True)  # noqa: T201  # a program for the shell
        installed(wheel, content / "lib" / f"python{PYTHON}" / "site-packages")
        packed(content, version)
    for path in sorted(DIST.glob(f"fleet?tui-{version}*")):
        print(f"{path.stat().st_size / 1e6:6.1f} MB  {path.relative_to(ROOT)}")  # noqa: T201  # as above


if __name__ == "__main__":
    main()
