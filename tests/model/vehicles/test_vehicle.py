"""Tests of model/vehicles/vehicle."""

import pytest

from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleConnection


@pytest.mark.parametrize(
    ("mode", "text"),
    [("", ""), ("AUTOMATIC", ""), ("SEMIAUTOMATIC", ""), ("MANUAL", "manual"), ("NEW", "new")],
)
def test_only_automatic_modes_take_orders(mode: str, text: str) -> None:
    vehicle = Vehicle("a", "2.0.0", mode=mode)
    assert vehicle.takes_orders is (not text) and vehicle.mode_text == text


def test_an_emergency_stop_has_its_word() -> None:
    assert Vehicle("a", "2.0.0").e_stop_text == ""
    assert Vehicle("a", "2.0.0", e_stop="AUTOACK").e_stop_text == "e-stop (autoack)"


@pytest.mark.parametrize(
    ("word", "text", "is_gone"),
    [
        ("ONLINE", "connected", False),
        ("OFFLINE", "signed off", True),
        ("CONNECTIONBROKEN", "connection broken", True),
        ("HIBERNATING", "hibernating", False),
        ("", "connection unknown", False),
    ],
)
def test_a_connection_in_words(word: str, text: str, is_gone: bool) -> None:
    connection = VehicleConnection(word, "a", "2.0.0")
    assert connection.text == text and connection.is_gone is is_gone
