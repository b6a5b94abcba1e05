"""Facts about links: what is known of a bridge after each."""

from fleet_tui.model import events
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.state.link_events import LinkEvent, apply_to_link
from fleet_tui.text.language import Message
from tests.support.fleets import LINK, T0, fleet, link_lost, link_up


def after(*facts: LinkEvent) -> LinkState:
    state = fleet()
    for fact in facts:
        state = apply_to_link(state, fact)
    return state.links[LINK]


def test_since_is_the_moment_of_the_loss_however_often_it_is_tried() -> None:
    tries = [events.LinkChanged(LINK, T0 + n, Phase.CONNECTING) for n in (6, 7)]
    link = after(link_up(T0), link_lost(T0 + 5, "the bridge went away"), *tries)
    assert (link.since, link.reason) == (T0 + 5, "the bridge went away")
    back = after(link_up(T0), link_lost(T0 + 5), link_up(T0 + 9))
    assert (back.since, back.reason, back.phase) == (T0 + 9, "", Phase.UP)


def test_what_a_bridge_lacks_is_forgotten_with_the_link() -> None:
    lacks = events.MessagesUnsourced(LINK, "OH_ressources")
    assert after(link_up(T0), lacks).unsourced == "OH_ressources"
    assert after(link_up(T0), lacks, link_lost(T0 + 1)).unsourced == ""


def test_the_command_path_is_a_state_of_its_own() -> None:
    dead = events.CommandPathChanged(LINK, CommandPath.DEAD, Message("no answer"), connected=True)
    link = after(link_up(T0), dead)
    assert (link.phase, link.command_path, link.command_reason) == (Phase.UP, CommandPath.DEAD, "no answer")
    assert link.commands_connected


def test_bad_frames_are_counted_and_the_newest_is_named() -> None:
    state = fleet()
    for text in ("no JSON", "x" * 10_000):
        state = apply_to_link(state, events.FrameRejected(LINK, text))
    assert state.links[LINK].faults == 2 and len(state.links[LINK].last_fault) < 600


def test_a_link_that_returns_tells_how_long_it_was_lost_until_it_is_lost_again() -> None:
    assert after(link_up(T0)).outage == 0.0
    tries = events.LinkChanged(LINK, T0 + 6, Phase.CONNECTING)
    back = after(link_up(T0), link_lost(T0 + 5), tries, link_up(T0 + 27), link_up(T0 + 28))
    assert back.outage == 22.0
    assert after(link_up(T0), link_lost(T0 + 5), link_up(T0 + 27), link_lost(T0 + 30)).outage == 0.0


def test_a_link_is_ready_from_its_last_subscription_on() -> None:
    begun = events.SubscriptionsAdvanced(LINK, T0 + 1, 50, 900)
    link = after(link_up(T0), begun)
    assert (link.topics, link.waiting_topics, link.ready_since) == (900, 850, T0 + 1)
    lost = after(link_up(T0), begun, link_lost(T0 + 5), link_up(T0 + 9))
    assert (lost.waiting_topics, lost.ready_since) == (0, T0 + 9)
