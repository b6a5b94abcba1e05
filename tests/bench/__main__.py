"""Runs the main() of every bench_*.py in this folder."""

import importlib
from pathlib import Path


def main() -> None:
    for path in sorted(Path(__file__).parent.glob("bench_*.py")):
        print(f"== {path.stem}", flush=True)
        importlib.import_module(f"{__package__}.{path.stem}").main()


if __name__ == "__main__":
    main()
