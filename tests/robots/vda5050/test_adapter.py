"""The kind, by role and by site."""

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.model.commands import Stage
from fleet_tui.model.kind import CANCEL, ORDER, PAUSE, RESUME
from fleet_tui.model.set_up.commands import Localise
from fleet_tui.text.errors import CommandError, ConfigError, WireError
from tests.support.vda_fleet import VehicleSite, config_text


@pytest.mark.parametrize(
    ("role", "can"),
    [("watch", set()), ("pause", {PAUSE, RESUME}), ("master", {PAUSE, RESUME, ORDER, CANCEL})],
)
def test_a_role_says_what_may_be_asked(role: str, can: set[str]) -> None:
    kind = VehicleSite(from_text(config_text(role=role))).adapter.kind
    for ability in (PAUSE, RESUME, ORDER, CANCEL):
        assert kind.can(ability) is (ability in can)
        if ability not in can:
            noun = "orders" if ability == ORDER else ability
            assert kind.lack(ability).startswith(f"links.broker.role is {role}: no {noun}")


def test_the_topics_of_a_vehicle_are_those_of_the_standard_or_of_its_template() -> None:
    site = VehicleSite()
    addresses = [feed.address for feed in site.adapter.feeds("agv", [])]
    assert addresses[:2] == ["+/+/KIT/0001/connection", "+/+/KIT/0001/state"] and len(addresses) == 6
    other = VehicleSite(from_text(config_text(settings='topic = "agv/{serial}/{name}"')))
    assert next(iter(other.adapter.feeds("agv", []))).address == "agv/0001/connection"
    assert other.adapter.vehicle("unknown") == ("", "unknown")


def test_what_only_bridges_have_is_refused() -> None:
    site = VehicleSite()
    adapter, feed = site.adapter, next(iter(site.adapter.feeds("agv", [])))
    assert not [*adapter.services("agv"), *adapter.publications("agv"), *adapter.probes("agv")]
    with pytest.raises(WireError):
        adapter.read(feed, b"", 0.0)
    with pytest.raises(WireError):
        adapter.stream(feed, b"")
    with pytest.raises(CommandError, match="this kind has no global localisation"):
        adapter.outgoing(Localise("agv"), 1, site.agv, "0" * 32)
    assert adapter.outcome(Localise("agv"), {}, True) == (Stage.UNKNOWN, "")


@pytest.mark.parametrize(
    ("settings", "problem"),
    [
        ("interfaces = 'x'", "profile.vda5050.interfaces: unknown key, did you mean interface?"),
        ("deviation = -1", "profile.vda5050: Expected `float` >= 0.0 - at `$.deviation`"),
    ],
)
def test_its_settings_are_checked(settings: str, problem: str) -> None:
    with pytest.raises(ConfigError) as found:
        from_text(config_text(settings=settings))
    assert problem in found.value.problems
