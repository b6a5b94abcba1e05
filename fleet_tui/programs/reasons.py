"""Reasons that a process of systemd, ssh or a site failed, with their remedies."""

from collections.abc import Mapping

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.programs.process import EndedProcess
from fleet_tui.programs.session_state import exit_text
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

SSH_FAILED = 255
NOT_FOUND = 127
NO_SYSTEMD = ("not been booted with systemd", "Failed to connect to", "systemctl: not found")
_OF_SSH = {
    "Permission denied (": "{host} does not accept this user's key: try ssh-copy-id {host}",
    "Host key verification failed": "{host} is not known here: connect once with ssh {host}",
    "Could not resolve hostname": "{host} has no address: check host, and ~/.ssh/config",
    "onnection refused": "{host} refuses ssh: is its sshd running?",
    "timed out": "{host} does not answer: is it on, and in this network?",
    "No route to host": "{host} can't be reached: is it on, and in this network?",
    "onnection closed": "{host} closed the connection: try ssh {host}",
}
_OF_SYSTEMD = {
    "authentication required": "not allowed for this user: add a polkit rule, or use a unit with user = true",
    "Access denied": "not allowed for this user: add a polkit rule, or use a unit with user = true",
    "not been booted with systemd": "no systemd to ask: use start, stop and status instead of unit",
    "Failed to connect to": "no systemd of this user to ask: log in first, or use start, stop and status",
}
_OF_SHELL = {"not found": "{last}: install it there, or write its full path in the configuration"}


def failure(program: ProgramEntry, ended: EndedProcess) -> str:
    """Return the reason that a process failed, and what to do."""
    if ended.problem:
        where = Message(" from {host}", host=program.host) if program.host and ended.is_late else ""
        return ended.problem.replace("no answer", Message("no answer{where}", where=Message(where)))
    last = last_line(ended.output)
    for words, remedy in _remedies(program, ended).items():
        if words in ended.output:
            return remedy.format(host=program.host or "this machine", last=last)
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


def last_line(output: str) -> str:
    """Return the last line with text."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return sanitize(truncate(lines[-1])) if lines else ""
