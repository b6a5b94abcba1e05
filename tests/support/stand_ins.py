"""systemd and ssh where they don't run: small programs of their names, put first on PATH."""

from pathlib import Path

import pytest

from fleet_tui.config.programs import ProgramEntry

SYSTEMCTL = """#!/bin/sh
echo "systemctl $*" >> "$STAND_IN/calls"
for unit; do :; done
file="$STAND_IN/$unit"
case " $* " in
*" show "*) cat "$file" 2>/dev/null || printf 'LoadState=not-found\\nActiveState=inactive\\n';;
*" reset-failed "*) ;;
*" stop "*) printf 'LoadState=loaded\\nActiveState=inactive\\n' > "$file";;
*) [ -e "$file.refuses" ] && { cat "$file.refuses"; exit 1; }
   [ -e "$file.next" ] && { cp "$file.next" "$file"; exit 0; }
   printf 'LoadState=loaded\\nActiveState=active\\nNRestarts=2\\nInvocationID=%s\\n' $$ > "$file"
   printf 'StateChangeTimestamp=Mon 2024-05-06 08:00:00 UTC\\nRequiredBy=nav2.service\\n' >> "$file";;
esac
"""
SYSTEMD_RUN = """#!/bin/sh
echo "systemd-run $*" >> "$STAND_IN/calls"
for one; do case $one in --unit=*) unit=${one#--unit=};; esac; done
printf 'LoadState=loaded\\nActiveState=active\\nInvocationID=%s\\n' $$ > "$STAND_IN/$unit"
"""
JOURNALCTL = """#!/bin/sh
echo "journalctl $*" >> "$STAND_IN/calls"
printf '\\033[31m2024-05-06 first\\033[0m line\\n2024-05-06 \\377 second\\033]52;c;eA==\\007\\n'
case " $* " in *" --follow "*) exec sleep 60;; esac
"""
SSH = """#!/bin/sh
echo "ssh $*" >> "$STAND_IN/calls"
[ -e "$STAND_IN/unreachable" ] && { echo "ssh: connect to host $5 port 22: No route to host"; exit 255; }
for line; do :; done
exec sh -c "$line"
"""
NO_SYSTEMD = """#!/bin/sh
echo 'Failed to connect to bus: No medium found' >&2
exit 1
"""


class StandIns:
    """`folder` has a file for each unit, with the output of `systemctl show`; `calls` is what was called."""

    def __init__(self, folder: Path, programs: Path) -> None:
        self.folder, self._programs = folder, programs
        for name, text in (
            ("systemctl", SYSTEMCTL),
            ("systemd-run", SYSTEMD_RUN),
            ("journalctl", JOURNALCTL),
            ("ssh", SSH),
        ):
            self.program(name, text)

    def program(self, name: str, text: str) -> str:
        path = self._programs / name
        path.write_text(text)
        path.chmod(0o755)
        return str(path)

    def without_systemd(self) -> None:
        for name in ("systemctl", "systemd-run"):
            self.program(name, NO_SYSTEMD)

    def unit(self, name: str, **properties: str) -> None:
        (self.folder / name).write_text("".join(f"{key}={value}\n" for key, value in properties.items()))

    @property
    def calls(self) -> list[str]:
        path = self.folder / "calls"
        return path.read_text().splitlines() if path.exists() else []


@pytest.fixture
def stand_ins(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> StandIns:
    folder, programs = tmp_path / "units", tmp_path / "bin"
    folder.mkdir()
    programs.mkdir()
    monkeypatch.setenv("STAND_IN", str(folder))
    monkeypatch.setenv("PATH", str(programs), prepend=":")
    return StandIns(folder, programs)


BRIDGE = ProgramEntry("bridge", unit="rosbridge.service")
REMOTE = ProgramEntry("bridge", unit="rosbridge.service", host="server")
KEPT = ProgramEntry("mapping", start=["sleep", "60"])


def with_status(folder: Path) -> ProgramEntry:
    """A program that a site starts and stops with programs of its own: it runs while a file is there."""
    flag = str(folder / "runs")
    return ProgramEntry("nav", start=["touch", flag], stop=["rm", flag], status=["test", "-e", flag])
