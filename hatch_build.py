"""Compiles the catalogues of the screen's languages when the program is built or installed."""

from io import BytesIO
from pathlib import Path
from typing import Any

from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po
from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class CompiledCatalogues(BuildHookInterface):
    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        compile_catalogues(Path(self.root))
        build_data["artifacts"].append("fleet_tui/locales/**/*.mo")


def compile_catalogues(root: Path) -> None:
    """Write a .mo file beside each .po file, unless it is there."""
    for path in root.glob("fleet_tui/locales/*/LC_MESSAGES/*.po"):
        compiled = BytesIO()
        with path.open("rb") as file:
            write_mo(compiled, read_po(file))
        made = path.with_suffix(".mo")
        if not made.is_file() or made.read_bytes() != compiled.getvalue():
            made.write_bytes(compiled.getvalue())


if __name__ == "__main__":
    compile_catalogues(Path(__file__).parent)
