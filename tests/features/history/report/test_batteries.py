"""Battery curves."""

from fleet_tui.features.history.report.page import HEIGHT, WIDTH, batteries
from fleet_tui.model.history.totals import ChargeTotal


def test_a_curve_has_gaps_where_nobody_watched_and_says_its_levels() -> None:
    levels = ((0, 80.0, 90.0), (1, 70.0, 75.0), (3, 12.0, 40.0))
    charges = {"robot_0": [ChargeTotal("robot_0", *one) for one in levels]}
    (figure,) = batteries(charges, 4, 20.0)
    limit, curve = figure.iter("path")
    assert limit.get("d") == f"M0,{0.8 * HEIGHT:.1f}H{WIDTH:g}"
    assert str(curve.get("d")).count("M") == 2 and str(curve.get("d")).count("L") == 1
    assert "".join(figure.itertext()) == "robot_0 40 %, lowest 12 %"


def test_impossible_levels_stay_in_the_picture() -> None:
    charges = {"r": [ChargeTotal("r", 0, -5.0, 250.0)]}
    (figure,) = batteries(charges, 1, 20.0)
    assert f"{WIDTH / 2:.1f},0.0" in str(list(figure.iter("path"))[1].get("d"))
