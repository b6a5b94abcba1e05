"""Orders to give again: the last one, then the most frequent, as far as their places still exist."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.language.favourites import MOST, OFTEN, Given, favourites, given_here
from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.commands import Stage
from tests.support.fleets import F0, R0, T0, commanded, fleet, graph, labels, place_order, reduced

NAMES = {"1": "Base", "2": "Store", "3": "Packing"}
PLACES = [Place(id_, name, F0) for id_, name in NAMES.items()]


def order(start: str, end: str) -> Given:
    return Given(start, NAMES.get(start, start), end, NAMES.get(end, end))


def texts(*orders: Given, places: list[Place] = PLACES) -> list[str]:
    return [f"{one.start.name} -> {one.end.name}, {one.reason}" for one in favourites(places, orders)]


def test_the_last_one_leads_and_the_most_frequent_follow() -> None:
    often, seldom = order("3", "2"), order("2", "1")
    given = [order("1", "2"), *[often] * 14, *[seldom] * 3, *[order("3", "1")] * 2]
    assert texts(*given) == ["Base -> Store, last", "Packing -> Store, 14 times", "Store -> Base, 3 times"]


def test_the_last_one_is_not_listed_twice_and_once_is_not_often() -> None:
    assert texts(order("1", "2"), order("1", "2"), order("2", "3")) == ["Base -> Store, last"]
    assert texts() == []


def test_orders_with_a_place_that_is_gone_are_left_out() -> None:
    assert texts(order("1", "9"), order("2", "1")) == ["Store -> Base, last"]


def test_a_label_means_the_same_place_on_another_graph_and_an_id_decides_among_several() -> None:
    moved = [Place("7", "Base", F0), Place("2", "Store", F0)]
    assert texts(order("1", "2"), places=moved) == ["Base -> Store, last"]
    several = [Place("1", "Base", "attic"), Place("7", "Base", F0), Place("2", "Store", F0)]
    (found,) = favourites(several, [order("1", "2")])
    assert found.start.floor == "attic"
    assert texts(order("8", "2"), Given("8", "Base", "2", "Store"), places=several) == []


def test_only_orders_of_two_places_that_left_this_console_count() -> None:
    known = (graph(1, 2, 3), labels({1: "Base", 2: "Store"}))
    state = reduced(
        fleet(),
        *known,
        *commanded(1, place_order(R0, 1, 2), Stage.SENT),
        *commanded(2, place_order(R0, 2), Stage.SENT),
        *commanded(3, place_order(R0, 1, 2, 3), Stage.SENT),
        *commanded(4, place_order(R0, 2, 1), Stage.NOT_SENT),
        *commanded(5, place_order(R0, 2, 3), Stage.WAITING, at=T0 + 1),
    )
    assert list(given_here(state)) == [Given("2", "Store", "3", "3"), Given("1", "Base", "2", "Store")]


ORDERS = st.lists(st.builds(order, *2 * [st.sampled_from(["1", "2", "3", "9"])]), max_size=30)


@given(ORDERS)
def test_there_are_few_each_once_and_no_order_left_out_is_more_frequent(given: list[Given]) -> None:
    found = favourites(PLACES, given)
    ends = [(one.start.vertex, one.end.vertex) for one in found]
    assert len(found) <= MOST and len(set(ends)) == len(ends)
    times = {end: sum((one.start, one.end) == end for one in given) for end in ends}
    left = [one for one in given if (one.start, one.end) not in times and "9" not in (one.start, one.end)]
    least = min((times[end] for end in ends[1:]), default=0) if len(found) == MOST else OFTEN - 1
    assert all(sum(other == one for other in given) <= least for one in left)
