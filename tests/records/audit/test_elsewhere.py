"""What other consoles of this machine do to orders, as their audit log tells it."""

import itertools
from pathlib import Path

import pytest

from fleet_tui.model.commands import CancelOrder, ClearOrders, Stage
from fleet_tui.model.desk.desk import CommandElsewhere
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.records.audit.elsewhere import command_of, watched_commands
from fleet_tui.records.audit.entries import Origin
from fleet_tui.state.store import Store
from tests.support.fleets import R0, T0, fleet
from tests.support.polling import eventually
from tests.support.records import ANA, give, record, watched

URL = next(iter(fleet().links.values())).url
BEN = Origin("ben", "host:2", "run2")


def found(**fields: object) -> CommandElsewhere | None:
    return command_of(record(**{"id": 3, "url": URL, **fields}), fleet(), "host:9", T0)  # type: ignore[arg-type]  # the fields of a record


@pytest.mark.parametrize("change", ["sent", "accepted", "refused", "not confirmed"])
def test_a_cancel_or_clear_is_told_with_its_author_and_stage(change: str) -> None:
    cancel = found(what="cancel", order="7", change=change)
    assert cancel == CommandElsewhere("run1 3", R0, "7", "ana", "host:1", T0, Stage(change), "cancel")
    clear = found(what="clear", change=change)
    assert clear is not None and clear.order_id == "" and clear.text == "cleared by ana at host:1"


def test_what_removes_no_order_is_told_with_its_name() -> None:
    order = found(what="order", order="7", change="confirmed")
    assert order is not None and (order.what, order.order_id, order.removes) == ("order", "", False)


@pytest.mark.parametrize(
    "fields",
    [
        {"kind": "alarm"},
        {"what": "clear", "change": "checked"},  # it may never be sent
        {"what": "clear", "change": "console closed"},
        {"what": "clear", "robot": "stranger"},
        {"what": "clear", "url": "ws://another:9090"},  # a robot of the same name at another site
    ],
)
def test_nothing_else_is_a_command_to_a_robot_of_ours(fields: dict[str, object]) -> None:
    assert found(**fields) is None


def test_this_console_is_no_other_one() -> None:
    assert command_of(record(what="clear", url=URL), fleet(), ANA.console, T0) is None


def test_only_what_others_do_from_now_on_is_posted(tmp_path: Path) -> None:
    ben, _ = watched(tmp_path, BEN)
    give(ben, 1, ClearOrders(R0), Stage.SENT)
    posted: list[CommandedElsewhere] = []
    own, _ = watched(tmp_path, ANA)
    numbers = itertools.count(3)

    def is_told() -> bool:
        give(ben, next(numbers), CancelOrder(R0, "7"), Stage.SENT, Stage.REFUSED)
        return len(posted) > 1

    with watched_commands(tmp_path, Store(fleet()), posted.append, ANA.console):
        give(own, 2, ClearOrders(R0), Stage.SENT)
        eventually(is_told)
    assert {(one.command.console, one.command.order_id) for one in posted} == {("host:2", "7")}
    assert {one.command.stage for one in posted} == {Stage.SENT, Stage.REFUSED}


def test_a_folder_that_is_none_holds_nothing_up(tmp_path: Path) -> None:
    """It may be made later."""
    place, posted = tmp_path / "state", list[CommandedElsewhere]()
    place.write_text("no folder")
    numbers = itertools.count(1)

    def is_told() -> bool:
        give(ben, next(numbers), ClearOrders(R0), Stage.SENT)
        return bool(posted)

    with watched_commands(place, Store(fleet()), posted.append, ANA.console):
        place.unlink()
        ben, _ = watched(place, BEN)
        eventually(is_told)
