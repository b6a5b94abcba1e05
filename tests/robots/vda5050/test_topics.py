"""Tests of robots/vda5050/topics."""

from fleet_tui.robots.vda5050.topics import Topics, with_name


def test_a_topic_says_whose_it_is_and_leads_to_the_others_of_its_vehicle() -> None:
    topics = Topics()
    address = topics.parse("uagv/v2/KIT/0001/state")
    assert address is not None
    assert (address.manufacturer, address.serial, address.name) == ("KIT", "0001", "state")
    assert with_name(address.base, "order") == "uagv/v2/KIT/0001/order"
    assert topics.parse("uagv/v2/KIT/state") is None and topics.parse("a/b/c/d/e/f") is None
    assert topics.filter("state", "KIT", "0001") == "+/+/KIT/0001/state"
    assert topics.filter("connection") == "+/+/+/+/connection"
    assert Topics(interface="uagv").filter("state") == "uagv/+/+/+/state"


def test_a_site_may_have_other_levels() -> None:
    topics = Topics("fleet/{serial}/{name}/json")
    address = topics.parse("fleet/0001/state/json")
    assert address is not None and (address.manufacturer, address.serial, address.name) == (
        "",
        "0001",
        "state",
    )
    assert with_name(address.base, "order") == "fleet/0001/order/json"
    assert topics.filter("state", "KIT", "0001") == "fleet/0001/state/json"
