"""Build what is released into dist/: the wheel, the sdist, and a single file that runs without either.

Run: python -m release.build, with the Python for which the single file is meant.
"""

import hashlib
import json
import platform
import shutil
import subprocess
import sys
import zipapp
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from release.locked import LOCK, ROOT, constraints, locked

DIST = ROOT / "dist"
PYTHON = ".".join(map(str, sys.version_info[:2]))


def built() -> Path:
    """Build wheel and sdist, and return the wheel."""
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-d", str(DIST)], cwd=ROOT, check=True)
    return max(DIST.glob("*.whl"), key=lambda path: path.stat().st_mtime)


def installed(wheel: Path, site: Path) -> list[str]:
    """Install the wheel with all that it needs, in the tested versions and from files with the hashes of the
    lock. Returns the packages with their versions."""
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    with TemporaryDirectory() as name:
        folder = Path(name)
        planned, needed = folder / "planned.json", folder / "needed.txt"
        dry = [
            "--dry-run",
            "--ignore-installed",
            "--report",
            str(planned),
            *constraints(folder / "versions.txt"),
        ]
        subprocess.run([*pip, *dry, f"{wheel}[serve,bags]"], check=True)
        packages = [one["metadata"] for one in json.loads(planned.read_text())["install"]]
        needed.write_text(locked(one["name"] for one in packages if one["name"] != "fleet-tui"))
        to = ["--no-deps", "--no-compile", "--target", str(site)]
        subprocess.run([*pip, *to, "--require-hashes", "--requirement", str(needed)], check=True)
        subprocess.run([*pip, *to, str(wheel)], check=True)
    # Scripts for the Python of this machine.
    shutil.rmtree(site / "bin", ignore_errors=True)
    return sorted(f"{one['name']}=={one['version']}" for one in packages)


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


def record(files: Sequence[Path], version: str, packages: Sequence[str], to: Path = DIST) -> None:
    """Write what was built of what, and the checksums of all for `sha256sum -c`."""

    def git(*args: str) -> str:
        done = subprocess.run(["git", *args], cwd=ROOT, capture_output=True, text=True, check=False)
        return done.stdout.strip()

    built_of = {
        "version": version,
        "commit": git("rev-parse", "HEAD"),
        "changed": bool(git("status", "--porcelain")),
        "python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
        "lock": _sha256(LOCK),
        "packages": list(packages),
        "files": {path.name: _sha256(path) for path in files},
    }
    told = to / f"fleet-tui-{version}-py{PYTHON.replace('.', '')}-{platform.machine()}.build.json"
    told.write_text(json.dumps(built_of, indent=2) + "\n")
    listed = [*files, told]
    (to / "SHA256SUMS").write_text("".join(f"{_sha256(path)}  {path.name}\n" for path in listed))


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def main() -> None:
    """Build all three and print their sizes."""
    wheel = built()
    version = wheel.name.split("-")[1]
    with TemporaryDirectory() as folder:
        content = Path(folder)
        print("Collecting what the single file needs ...", flush=True)  # noqa: T201  # a program for the shell
        packages = installed(wheel, content / "lib" / f"python{PYTHON}" / "site-packages")
        packed(content, version)
    files = sorted(path for path in DIST.glob(f"fleet?tui-{version}*") if path.suffix != ".json")
    record(files, version, packages)
    for path in files:
        print(f"{path.stat().st_size / 1e6:6.1f} MB  {path.relative_to(ROOT)}")  # noqa: T201  # as above


if __name__ == "__main__":
    main()
