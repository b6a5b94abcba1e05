"""What part of each package the tests run, lines and branches, against the least that each may have:
`python -m tests.support.coverage_floors coverage.json floors.toml`."""

import json
import sys
import tomllib
from collections import Counter
from pathlib import Path

ROOT = "fleet_tui/"


def package_of(file: str) -> str:
    """The package at the top of a file, a feature by itself; `app` for the modules beside them."""
    head, *rest = file.removeprefix(ROOT).split("/")
    if head == "features" and len(rest) > 1:
        return f"{head}.{rest[0]}"
    return head if rest else "app"


def shares(report: dict[str, dict[str, dict[str, dict[str, int]]]]) -> dict[str, float]:
    """Percent of the lines and branches of each package that were run, of coverage's report in JSON."""
    ran, there = Counter[str](), Counter[str]()
    for file, found in report["files"].items():
        counts, package = found["summary"], package_of(file)
        ran[package] += counts["covered_lines"] + counts["covered_branches"]
        there[package] += counts["num_statements"] + counts["num_branches"]
    return {package: 100 * ran[package] / count for package, count in sorted(there.items()) if count}


def main(report: str, floors: str) -> int:
    """Print each package; return 1 if one is below its floor."""
    least = tomllib.loads(Path(floors).read_text())
    is_below = False
    for package, share in shares(json.loads(Path(report).read_text())).items():
        below = share < least.get(package, 0)
        is_below |= below
        print(f"{package:15} {share:5.1f} %  at least {least.get(package, 0)}" + "  FELL" * below)
    return is_below


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
