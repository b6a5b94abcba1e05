"""The options of the `graph` commands."""

from pathlib import Path

from fleet_tui.maps.formats.writing import WRITERS
from tests.support.cli import run


async def test_help_and_mistakes(tmp_path: Path) -> None:
    shown = await run(tmp_path, "graph", "--help")
    assert shown.code == 0 and all(word in shown.out for word in ("lint", "diff", "convert", "show"))
    assert "did you mean lint?" in (await run(tmp_path, "graph", "lnt")).err
    for args in (("convert", "x"), ("lint",), ("lint", ""), ("lint", "x", "--from", "dxf"), ("diff", "x")):
        done = await run(tmp_path, "graph", *args)
        assert done.code == 2 and "Traceback" not in done.err, args
    offered = (await run(tmp_path, "graph", "convert", "--help")).out
    assert f"--to [{'|'.join(one.value for one in WRITERS)}]" in offered, (
        "what can only be read is not offered"
    )
    done = await run(tmp_path, "graph", "lint", "x", "--building-graph", "9")
    assert done.code == 2
