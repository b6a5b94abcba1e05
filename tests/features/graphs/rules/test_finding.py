"""The number of findings is limited."""

from fleet_tui.features.graphs.rules.finding import MOST, GraphFinding, limited
from fleet_tui.text.language import Message, verbatim


def test_many_findings_of_a_rule_are_counted() -> None:
    few = [GraphFinding("x", verbatim(n), False) for n in range(MOST)]
    assert limited(few) == few
    assert limited([*few, *few])[MOST:] == [GraphFinding("x", Message("and {most} more", most=MOST), False)]
