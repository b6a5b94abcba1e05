"""Say which dependencies have known advisories: at their floors in pyproject.toml, and as locked.

Run: python -m release.advisories. pip-audit finds them, in an environment of its own; without a network
nothing is known, and that is said. It fails nothing: an advisory of today must not stop other work.
"""

import json
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from release.locked import LOCK, ROOT, versions

WITHIN = 180.0
"""Seconds for each step."""
_FLOOR = re.compile(r"^([A-Za-z0-9._-]+)(?:\[[^]]*\])?(?:>=|==)([^,;]+)")


def floors(pyproject: str) -> list[str]:
    """Return the lowest version of each dependency that a pyproject.toml allows."""
    project = tomllib.loads(pyproject)["project"]
    needed = [project["dependencies"], *project["optional-dependencies"].values()]
    found = (_FLOOR.match(one) for group in needed for one in group)
    return sorted({f"{floor[1]}=={floor[2].strip()}" for floor in found if floor})


def findings(where: str, audited: str) -> Iterator[str]:
    """Return what pip-audit's JSON tells, a line for each package with advisories, and how many it could not
    check."""
    packages = json.loads(audited)["dependencies"]
    for one in packages:
        known = one.get("vulns", [])
        if known:
            ids = ", ".join(sorted(vuln["id"] for vuln in known))
            fixed = sorted({version for vuln in known for version in vuln["fix_versions"]})
            remedy = f"fixed in {', '.join(fixed)}" if fixed else "not fixed yet"
            yield f"{where}: {one['name']} {one['version']} has {ids}: {remedy}"
    if unchecked := sum("skip_reason" in one for one in packages):
        yield f"{where}: {unchecked} of {len(packages)} packages not checked"


def _audited(python: Path, pinned: Sequence[str], folder: Path) -> str:
    listed = folder / "listed.txt"
    listed.write_text("\n".join(pinned) + "\n")
    options = ["--no-deps", "--disable-pip", "--progress-spinner", "off", "--format", "json"]
    audit = [str(python), "-m", "pip_audit", "--requirement", str(listed), *options]
    return subprocess.run(audit, capture_output=True, text=True, timeout=WITHIN, check=False).stdout


def main() -> None:
    """Print the findings."""
    say = sys.stdout.write
    with TemporaryDirectory() as name:
        folder = Path(name)
        python = folder / "venv" / "bin" / "python"
        install = [str(python), "-m", "pip", "install", "--quiet", "pip-audit"]
        try:
            subprocess.run([sys.executable, "-m", "venv", str(folder / "venv")], check=True, timeout=WITHIN)
            subprocess.run(install, check=True, timeout=WITHIN, capture_output=True)
            checked = {
                "floor": floors((ROOT / "pyproject.toml").read_text()),
                "lock": versions(LOCK.read_text()),
            }
            for where, pinned in checked.items():
                for line in findings(where, _audited(python, pinned, folder)):
                    say(f"{line}\n")
        except (OSError, subprocess.SubprocessError, ValueError, KeyError) as problem:
            say(f"advisories not checked: no answer ({type(problem).__name__})\n")


if __name__ == "__main__":
    main()
