"""What a robot does, in the one word that all of the screen has for it."""

from fleet_tui.model.fleet import FleetState, missing_text
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.robot import Robot
from fleet_tui.situation.activity import OBSTRUCTED, activities, halt_word
from fleet_tui.situation.alarms.trouble import acknowledged, waits
from fleet_tui.situation.facts import DRIVES_ON, E_STOP, FAULT, STUCK
from fleet_tui.situation.reported_motion import action_text, is_stuck, running_action, waits_for
from fleet_tui.text.language import Message, counted, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.news import failed_command, listed, news, shortened_news
from fleet_tui.ui.view.tables.table import Run, width_of

UNKNOWN = Message("unknown")
ODD = (E_STOP.word, FAULT.word, OBSTRUCTED, Activity.BLOCKED.value, STUCK.word, Activity.PAUSED.value)
"""Words of what needs a look, as counted."""
CALM = (Activity.IDLE, Activity.CHARGING)
STANDING = (Activity.WAITING, Activity.LOADING, Activity.BLOCKED)
"""What a robot does while it stands with an order: told with its seconds."""
PAGE = 500
"""Cells of a page: nothing is left out, for it has lines."""
STILL_FROM = 5.0
"""Seconds without movement from which they are told."""


def word(does: Activity | None) -> str:
    """Return the word for what a robot does, None if nothing fresh tells."""
    return translate(UNKNOWN if does is None else Message(does.value))


def doing_text(state: FleetState, robot: Robot, does: Activity | None) -> str:
    """Return `waiting 11 s` of a robot that stands with an order, `pick, 40 s` of one that says what it does
    there, else the word alone."""
    if does in (Activity.WAITING, Activity.LOADING) and (action := running_action(state, robot)) is not None:
        return sanitize(action_text(state, action))
    seconds = waits_for(state, robot)
    shown = translate(halt_word(state, robot)) if does is Activity.BLOCKED else word(does)
    return shown if does not in STANDING or seconds < STILL_FROM else f"{shown} {age(seconds)}"


def count_word(state: FleetState, robot: Robot, does: Activity | None) -> str:
    """Return the word that counts a robot, in English: that of its row."""
    if does is Activity.BLOCKED:
        return halt_word(state, robot)
    return UNKNOWN if does is None else does.value


def count_text(count: int, word: str) -> str:
    """Return the number of robots with a word: `2 obstacles`, `2 driving`."""
    counts = {
        OBSTRUCTED: counted("{count} obstacle", "{count} obstacles", count),
        E_STOP.word: counted("{count} e-stop", "{count} e-stops", count),
        FAULT.word: counted("{count} error", "{count} errors", count),
        STUCK.word: counted("{count} stuck", "{count} stuck", count),
        Activity.DRIVING.value: counted("{count} driving", "{count} driving", count),
        Activity.LOADING.value: counted("{count} loading", "{count} loading", count),
        Activity.WAITING.value: counted("{count} waiting", "{count} waiting", count),
        Activity.CHARGING.value: counted("{count} charging", "{count} charging", count),
        Activity.IDLE.value: counted("{count} idle", "{count} idle", count),
        Activity.PAUSED.value: counted("{count} paused", "{count} paused", count),
        Activity.BLOCKED.value: counted("{count} blocked", "{count} blocked", count),
        Activity.OFFLINE.value: counted("{count} offline", "{count} offline", count),
        UNKNOWN: counted("{count} unknown", "{count} unknown", count),
    }
    return translate(counts[word])


def doing_role(state: FleetState, robot: Robot) -> StyleRole:
    """Return the role of that text: amber where it lasts, red where it is an alarm."""
    if is_stuck(state, robot):
        return StyleRole.ALARM
    return StyleRole.WARN if waits(state, robot) else StyleRole.DIM


def state_texts(state: FleetState, robot: Robot, does: Activity | None, cells: int) -> list[Run]:
    """Return what a robot does, and its news before all: where not both have space, or the news says it,
    these alone."""
    failed, others = list(failed_command(state, robot)), list(news(state, robot))
    if failed and width_of(failed) > cells:
        failed = list(failed_command(state, robot, short=True))
    # What a robot that is not heard last reported comes after that.
    texts = shortened_news([*failed, *others] if state.is_online(robot) else [*others, *failed], cells)
    doing = doing_text(state, robot, does), doing_role(state, robot)
    if not texts:
        return [(missing(state, robot) or doing[0], doing[1]) if does is None else doing]
    # "lost idle" would read as one, and an emergency stop says that it is blocked.
    is_grave = any(role is StyleRole.ALARM for _, role in texts)
    is_said = does in (None, Activity.OFFLINE, Activity.PAUSED, *(*CALM, Activity.BLOCKED) * is_grave)
    is_said = is_said or (does is Activity.DRIVING and (state.is_paused(robot) or _drives_on(texts)))
    is_said = is_said or (does is Activity.WAITING and robot.name in state.deadlocks)
    is_said = is_said or any(text.startswith((word(does), translate(OBSTRUCTED))) for text, _ in texts)
    both = [*texts, doing]
    return texts if is_said or width_of(listed(both)) > cells else both


def _drives_on(texts: list[Run]) -> bool:
    return any(text == translate(DRIVES_ON.word) for text, _ in texts)


def missing(state: FleetState, robot: Robot) -> str:
    """Return which value of a robot is missing, as far as it is known to do nothing without an order."""
    is_missing_queue = robot.queue is None and robot.kind.expects("queue") and state.is_online(robot)
    return translate(missing_text(state, robot, "queue")) if is_missing_queue else ""


def with_progress(runs: list[Run], progress: str, cells: int) -> list[Run]:
    """Return the state with as much of the progress as there is space for."""
    for far in (progress, progress.partition(", ")[0]):
        told = [*runs, (far, StyleRole.DIM)]
        if far and width_of(told) <= cells:
            return told
    return runs


def page_texts(state: FleetState, robot: Robot, cells: int = PAGE) -> list[Run]:
    """Return what a robot does and its news for its page, shorter where they are more than `cells`: without
    red if all its alarms are acknowledged, as the tables have it."""
    does = activities(state, [robot]).get(robot.name)
    texts = state_texts(state, robot, does, cells)
    is_known = robot.name in acknowledged(state)
    told = [(text, StyleRole.WARN if is_known and role is StyleRole.ALARM else role) for text, role in texts]
    return [(text, StyleRole.TEXT if role is StyleRole.DIM else role) for text, role in told]


def told_text(state: FleetState, robot: Robot) -> str:
    """Return its state in its most urgent words alone: the first news, else what it does."""
    return page_texts(state, robot)[0][0]
