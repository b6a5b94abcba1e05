"""Words of several stacks for one purpose."""

import pytest

from fleet_tui.maps.formats.purposes import Purpose, purpose_of


@pytest.mark.parametrize(
    ("word", "purpose"),
    [
        ("", Purpose.PLAIN),
        ("HALT_POSITION", Purpose.PLAIN),
        ("PARK_POSITION", Purpose.PARKING),
        ("Elevator", Purpose.LIFT),
        ("docking_station", Purpose.CHARGER),
        ("shelf", Purpose.OTHER),
    ],
)
def test_purposes(word: str, purpose: Purpose) -> None:
    assert purpose_of(word) is purpose
