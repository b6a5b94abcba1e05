"""Reasons that a process of systemd, ssh or a site failed, with their remedies."""

from collections.abc import Mapping

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.programs.process import EndedProcess
from fleet_tui.programs.session_state import exit_text
from fleet_tui.text.language import EMPTY, N_, Message, verbatim
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

SSH_FAILED = 255
NOT_FOUND = 127
NO_SYSTEMD = ("not been booted with systemd", "Failed to connect to", "systemctl: not found")
_OF_SSH = {
    "Permission denied (": N_("{host} does not accept this user's key: try ssh-copy-id {host}"),
    "Host key verification failed": N_("{host} is not known here: connect once with ssh {host}"),
    "Could not resolve hostname": N_("{host} has no address: check host, and ~/.ssh/config"),
    "onnection refused": N_("{host} refuses ssh: is its sshd running?"),
    "timed out": N_("{host} does not answer: is it on, and in this network?"),
    "No route to host": N_("{host} can't be reached: is it on, and in this network?"),
    "onnection closed": N_("{host} closed the connection: try ssh {host}"),
}
_OF_SYSTEMD = {
    "authentication required": N_(
        "not allowed for this user: add a polkit rule, or use a unit with user = true"
    ),
    "Access denied": N_("not allowed for this user: add a polkit rule, or use a unit with user = true"),
    "not been booted with systemd": N_("no systemd here: use start, stop and status instead of unit"),
    "Failed to connect to": N_("no systemd for this user: log in first, or use start, stop and status"),
}
_OF_SHELL = {"not found": N_("{last}: install it there, or write its full path in the configuration")}


def failure(program: ProgramEntry, ended: EndedProcess) -> Message:
    """Return the reason that a process failed, and what to do."""
    if ended.problem:
        if program.host and ended.is_late:
            return Message("{host}: {problem}", host=program.host, problem=ended.problem)
        return ended.problem
    last = last_line(ended.output)
    for words, remedy in _remedies(program, ended).items():
        if words in ended.output:
            return Message(remedy, host=program.host or Message("this machine"), last=last)
    return last or exit_text(ended.code or 0)


def _remedies(program: ProgramEntry, ended: EndedProcess) -> Mapping[str, str]:
    """Return the remedies of whoever failed: a site's own program may print the same words."""
    if ended.code == NOT_FOUND:
        return _OF_SHELL
    if program.host and ended.code == SSH_FAILED:
        return _OF_SSH
    return {} if program.status else _OF_SYSTEMD


def has_no_systemd(ended: EndedProcess) -> bool:
    """Tell whether there is no systemd for this user to ask."""
    return ended.code != 0 and any(words in ended.output or words in ended.problem for words in NO_SYSTEMD)


def last_line(output: str) -> Message:
    """Return the last line with text."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return sanitize(verbatim(truncate(lines[-1]))) if lines else EMPTY
