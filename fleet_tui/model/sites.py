"""Sites: groups of links in one console, of which one is shown at a time, that of the selected robot."""

from collections import Counter
from collections.abc import Mapping

from msgspec.structs import replace

from fleet_tui.model.alarm import Alarm, AlarmStage
from fleet_tui.model.fleet import FleetState


def sites_of(state: FleetState) -> list[str]:
    """Return the sites in the order of the config, none if all links are of the same one. Links without a
    site are one of their own, named by an empty text."""
    names = list(dict.fromkeys(link.site for link in state.links.values()))
    return names if len(names) > 1 else []


def site_of(state: FleetState, robot: str) -> str:
    return state.links[state.robots[robot].link].site


def of_site(state: FleetState, robot: str) -> FleetState:
    """Return the part of the state about the site of a robot: its robots, their floors, alarms and commands,
    and the alarms of no site."""
    if not sites_of(state):
        return state
    site = site_of(state, robot)
    robots = {name: state.robots[name] for name in robots_at(state, site)}
    floors = {floor for one in robots.values() for floor in (*one.maps, one.floor)}
    alarms = [(alarm, _sites_of_alarm(state, alarm)) for alarm in state.alarms]
    return replace(
        state,
        robots=robots,
        floors={name: floor for name, floor in state.floors.items() if name in floors},
        alarms=tuple(alarm for alarm, sites in alarms if not sites or site in sites),
        commands=tuple(record for record in state.commands if record.command.robot in robots),
    )


def robots_at(state: FleetState, site: str) -> list[str]:
    return [name for name, robot in state.robots.items() if state.links[robot.link].site == site]


def alarms_by_site(state: FleetState) -> Mapping[str, int]:
    """Return the number of alarms that are not shelved of each site that has some."""
    alarms = (alarm for alarm in state.alarms if alarm.stage is not AlarmStage.SHELVED)
    found = Counter(site for alarm in alarms for site in _sites_of_alarm(state, alarm))
    return {site: found[site] for site in sites_of(state) if found[site]}


def _sites_of_alarm(state: FleetState, alarm: Alarm) -> set[str]:
    """Return the sites that an alarm is about, none for one of the console itself."""
    sources = [alarm.condition.source, *alarm.condition.parts]
    links = [state.robots[name].link if name in state.robots else name for name in sources]
    return {state.links[link].site for link in links if link in state.links}
