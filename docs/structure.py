"""Draws docs/architecture.png: the layers of the import contracts, with the lines of each package.

Run: python docs/structure.py
"""

import tomllib
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "fleet_tui"
WIDTH, ROW, GAP, MARGIN = 900, 44, 10, 24
FONT = ImageFont.load_default(17)
SMALL = ImageFont.load_default(13)
PAPER, INK, BOX, FEATURE = "#ffffff", "#1f2430", "#dfe7f1", "#f3e6c9"


def layers() -> list[list[str]]:
    """The names of each layer, from the top."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    (whole,) = (one for one in contracts if one["name"] == "Imports only go down")
    return [[name.strip().removeprefix("fleet_tui.") for name in line.split("|")] for line in whole["layers"]]


def lines_of(name: str) -> int:
    """The lines of a package or module."""
    folder = PACKAGE / name
    files = folder.rglob("*.py") if folder.is_dir() else [folder.with_suffix(".py")]
    return sum(len(file.read_text().splitlines()) for file in files)


def draw_row(draw: ImageDraw.ImageDraw, top: int, names: list[str], colour: str, of: str = "") -> None:
    """Draw boxes side by side, as wide as each other."""
    width = (WIDTH - 2 * MARGIN - GAP * (len(names) - 1)) // len(names)
    for number, name in enumerate(names):
        left = MARGIN + number * (width + GAP)
        draw.rounded_rectangle((left, top, left + width, top + ROW), 6, fill=colour, outline=INK)
        draw.text((left + width / 2, top + 15), name, INK, FONT, anchor="mm")
        draw.text((left + width / 2, top + 33), f"{lines_of(of + name):,} lines", INK, SMALL, anchor="mm")


def main() -> None:
    features = sorted(
        path.name for path in (PACKAGE / "features").iterdir() if (path / "__init__.py").exists()
    )
    half = (len(features) + 1) // 2
    rows = [
        row
        for names in layers()
        for row in (
            [(features[:half], FEATURE, "features/"), (features[half:], FEATURE, "features/")]
            if names == ["features"]
            else [(names, BOX, "")]
        )
    ]
    image = Image.new("RGB", (WIDTH, 2 * MARGIN + len(rows) * (ROW + GAP) - GAP), PAPER)
    draw = ImageDraw.Draw(image)
    for number, (names, colour, of) in enumerate(rows):
        draw_row(draw, MARGIN + number * (ROW + GAP), names, colour, of)
    image.quantize(16).save(ROOT / "docs" / "architecture.png", optimize=True)


if __name__ == "__main__":
    main()
