"""Runs the main() of every bench_*.py in this folder: python -m tests.bench [--json FILE]"""

import argparse
import importlib
import json
from pathlib import Path

from tests.bench.rows import Row, held, table


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.bench", description=__doc__)
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there too")
    file: Path | None = parser.parse_args().json
    rows: list[Row] = []
    for path in sorted(Path(__file__).parent.glob("bench_*.py")):
        print(f"== {path.stem}", flush=True)
        rows += importlib.import_module(f"{__package__}.{path.stem}").main()
    rows.sort(key=lambda made: int(made["id"][1:]))
    print("\n" + table(rows))
    missed = [made for made in rows if not held(made)]
    print(f"\n{len(missed)} of {sum(made['target'] is not None for made in rows)} targets are not held")
    if file:
        kept = [{**made, "held": held(made) if made["target"] is not None else None} for made in rows]
        file.write_text(json.dumps(kept, indent=1) + "\n")


if __name__ == "__main__":
    main()
