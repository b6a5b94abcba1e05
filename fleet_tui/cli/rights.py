"""The `rights` command: what the user of this process may do, and why."""

from collections.abc import Iterator

from fleet_tui.config import rights
from fleet_tui.config.rights import own_groups, own_rights, own_user
from fleet_tui.model.problem import Right
from fleet_tui.text.sanitize import sanitize

MEANING = {
    Right.VIEW: "see everything, command nothing",
    Right.DISPATCH: "orders, goals, cancels, pauses, routines, the desk",
    Right.SETUP: "all of dispatch; poses, mapping, graphs, driving by hand, programs",
}


def rights_lines() -> Iterator[str]:
    """Yield one's right, its meaning, and the file it comes from."""
    own = own_rights()
    yield sanitize(f"{own_user()}: {own.right.word} ({MEANING[own.right]})")
    yield sanitize(f"groups: {' '.join(own_groups()) or 'none'}")
    if own.why:
        yield sanitize(f"refused, so that everybody may only view: {own.why}")
    else:
        there = rights.FILE.exists()
        yield f"{rights.FILE}" if there else f"no {rights.FILE}: everybody may do everything"
