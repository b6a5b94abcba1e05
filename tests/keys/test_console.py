"""Keys of the console: the action each calls, and which of them command robots."""

from fleet_tui.actions import AlarmActions, AppActions, CommandActions, FileActions, ViewActions
from fleet_tui.keys.console import CONSOLE
from fleet_tui.keys.key import by_id
from tests.support.key_calls import calls

CALLS = calls(CONSOLE)


def test_every_action_has_a_key_and_is_called_by_the_key_of_its_name() -> None:
    groups = {
        "app": AppActions,
        "commands": CommandActions,
        "view": ViewActions,
        "alarms": AlarmActions,
        "files": FileActions,
    }
    actions = {f"{name}.{field}" for name, group in groups.items() for field in group.__struct_fields__}
    called = {call.partition("(")[0] for call in CALLS.values()}
    assert actions - called == {"view.go_to_time"}, "only a recording has it"
    assert called <= actions
    others = {id_: call for id_, call in CALLS.items() if call.partition(".")[2] != f"{id_}()"}
    assert set(others) == {
        *("help_anywhere", "pause_all_anywhere"),
        *(
            f"{step}_{what}{plain}"
            for step in ("next", "previous")
            for what in ("robot", "floor")
            for plain in ("", "_plain")
        ),
        *(f"robot_{n}" for n in range(1, 10)),
    }
    assert others["help_anywhere"] == "view.help()"
    assert others["pause_all_anywhere"] == "commands.pause_all()"


def test_keys_with_a_number_or_a_direction_pass_it_on() -> None:
    assert [CALLS[f"robot_{n}"] for n in range(1, 10)] == [f"view.choose_robot({n})" for n in range(1, 10)]
    for name in ("robot", "floor"):
        assert CALLS[f"next_{name}"] == f"view.step_{name}(1)"
        assert CALLS[f"previous_{name}"] == f"view.step_{name}(-1)"
        for step in ("next", "previous"):
            assert CALLS[f"{step}_{name}_plain"] == CALLS[f"{step}_{name}"]


def test_keys_that_command_are_hidden_from_who_may_not_and_need_a_robot_that_can() -> None:
    commanding = {id_ for id_, call in CALLS.items() if call.startswith("commands.")}
    marked = {key.id for key in CONSOLE if key.commands}
    assert commanding - marked == {"arm"}, "arming is what permits the others"
    assert marked <= commanding and all(by_id(CONSOLE)[id_].needs for id_ in marked)
