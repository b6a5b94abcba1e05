"""What of a configuration does not count because somebody else could have written it, or a file it names."""

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.schema import LINK_FILES, SECRETS, Config, DeskConfig, Link, Notify
from fleet_tui.config.small_file import read_text
from fleet_tui.config.trust import accept, doubt, doubt_of_content
from fleet_tui.text.language import EMPTY, Message

TRUST = "--trust-config trusts what is in it now"
OFF = "no notify, programs, routines, credentials, desk, control of vehicles, sent graphs"
LARGEST = 40_000_000
"""Bytes of a file whose content is looked at: the largest graph."""
CREDENTIALS = (*(key for key in LINK_FILES if key != "ca_file"), *(f"{key}_env" for key in SECRETS))


def or_trusted(doubt: str) -> Message:
    """Return a doubt with the remedy that only contents have."""
    return Message("{doubt}; or {trust}", doubt=doubt, trust=TRUST)


def safe(config: Config, text: str) -> Config:
    """Return the configuration of a file with this text without what must come from safe files: programs,
    credentials, control of vehicles, the desk. Routines and sent graphs look at `doubt`, and at their
    own files."""
    accept(config.path, text)
    if found := doubt_of_content(config.path, text):
        return replace(
            _with_links(config, _without_credentials),
            notify=Notify(),
            programs=[],
            desk=DeskConfig(),
            doubt=found,
            withheld=[f"opened without programs and credentials: {or_trusted(found)}. Until then: {OFF}"],
        )
    return _with_safe_files(config)


def _with_safe_files(config: Config) -> Config:
    """Return the configuration without what runs or follows a file that somebody else could have written."""
    told: list[str] = []
    notify, desk = config.notify, config.desk
    if found := doubt_of_command(notify.command, config.path.parent):
        notify = Notify()
        told.append(f"notify is off: {found}")
    if desk.folder and (found := doubt(config.beside(desk.folder), is_for_group=True)):
        desk = DeskConfig()
        told.append(f"the desk is off: {found}")
    doubts = {program.name: doubt_of_program(program) for program in config.programs}
    told += [f"program {name} is off: {found}" for name, found in doubts.items() if found]
    graphs = [config.beside(floor.graph) for floor in config.floors if floor.graph]
    is_master = any(link.role == "master" for link in (config.rosbridge, *config.links.values()))
    if is_master and (unsafe := next(_doubts_of_contents(graphs), "")):
        config = _with_links(config, _only_watched)
        told.append(f"vehicles are only watched: {or_trusted(unsafe)}")
    told += [
        f"routines are off: {or_trusted(found)}"
        for found in dict.fromkeys(_doubts_of_contents(sorted(config.routine_folder.glob("*.routine"))))
    ]
    return replace(
        config,
        notify=notify,
        desk=desk,
        programs=[program for program in config.programs if not doubts[program.name]],
        withheld=told,
    )


def doubt_of_command(arguments: Sequence[str], folder: Path) -> Message:
    """Return how somebody else could have written the program of a command, or a file or folder among its
    arguments, also behind `=`; names that PATH finds are the user's own choice."""
    program = arguments[0] if arguments else ""
    values = (word.partition("=")[2] for word in arguments)
    named = [name for name in (*arguments, *values) if name and "\0" not in name]
    for name in named:
        file = folder / name
        is_program = name == program and "/" in name  # it may come to be there only later
        if (is_program or os.path.lexists(file)) and (found := doubt(file)):
            return found
    return EMPTY


def doubt_of_program(program: ProgramEntry) -> str:
    """Return the same of a program of this machine: its words are relative to the current folder."""
    if program.host:
        return ""
    commands = program.start, program.stop, program.status, program.log
    return next((found for one in commands if (found := doubt_of_command(one, Path.cwd()))), "")


def _doubts_of_contents(files: Sequence[Path]) -> Iterator[str]:
    for file in files:
        if not doubt(file):
            continue
        try:
            text = read_text(file, LARGEST)
        except (OSError, ValueError):  # told where it is used
            continue
        accept(file, text)
        if found := doubt_of_content(file, text):
            yield found


def _with_links(config: Config, change: Callable[[Link], Link]) -> Config:
    links = {name: change(link) for name, link in config.links.items()}
    return replace(config, rosbridge=change(config.rosbridge), links=links)


def _without_credentials(link: Link) -> Link:
    return replace(link, role="watch", **dict.fromkeys(CREDENTIALS, ""))


def _only_watched(link: Link) -> Link:
    return replace(link, role="watch") if link.role == "master" else link
