"""Rights of the Unix user and groups that this process really has."""

import os
from pathlib import Path

import pytest

from fleet_tui.config import rights, trust
from fleet_tui.config.rights import own_groups, own_rights, own_user, permissions_of
from fleet_tui.config.schema import Config, Operator
from fleet_tui.model.problem import Permissions, Right


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return where the file of rights is in this test, as if its owner were root."""
    folder = tmp_path / "etc"
    folder.mkdir(mode=0o755)
    monkeypatch.setattr(rights, "FILE", folder / "rights.toml")
    monkeypatch.setattr(rights, "OWNER", os.getuid())
    return folder / "rights.toml"


def write(file: Path, text: str) -> None:
    file.write_text(text)
    file.chmod(0o644)


def test_without_the_file_everybody_may_do_everything(file: Path) -> None:
    assert own_rights() == Permissions() and own_rights().right is Right.SETUP


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("", Right.VIEW),
        ('[dispatch]\nusers = ["nobody-else"]\ngroups = ["none"]', Right.VIEW),
        ('[dispatch]\nusers = ["USER"]', Right.DISPATCH),
        ('[dispatch]\ngroups = ["GROUP"]', Right.DISPATCH),
        ('[dispatch]\nusers = ["USER"]\n[setup]\ngroups = ["GROUP"]', Right.SETUP),
        ('[view]\nusers = ["USER"]\n[setup]\nusers = ["someone"]', Right.VIEW),
    ],
)
def test_the_highest_right_of_user_and_groups_counts(file: Path, text: str, right: Right) -> None:
    write(file, text.replace("USER", own_user()).replace("GROUP", own_groups()[0]))
    assert own_rights() == Permissions(right=right)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[dispatch", "Expected ']'"),
        ("[dispach]", "unknown table [dispach] (did you mean dispatch?)"),
        ('[dispatch]\nuser = ["ana"]', "unknown key dispatch.user"),
        ('[dispatch]\nusers = "ana"', "dispatch.users must be a list of names"),
        ("dispatch = 1", "[dispatch] must be a table"),
        ("[dispatch]\nusers = [1]", "dispatch.users must be a list of names"),
    ],
)
def test_a_file_that_is_wrong_lets_everybody_only_view(file: Path, text: str, why: str) -> None:
    write(file, text)
    found = own_rights()
    assert found.right is Right.VIEW and f"{file}: " in found.why and why.split(" (did")[0] in found.why


@pytest.mark.parametrize(("mode", "by", "remedy"), [(0o664, "others", "g-w"), (0o646, "everyone", "o-w")])
def test_a_file_that_others_can_write_is_refused(
    file: Path, monkeypatch: pytest.MonkeyPatch, mode: int, by: str, remedy: str
) -> None:
    monkeypatch.setattr(trust, "members", lambda _group: {"eve"})
    write(file, f'[setup]\nusers = ["{own_user()}"]')
    file.chmod(mode)
    assert own_rights() == Permissions(
        right=Right.VIEW, why=f"{file}: {file} is writable by {by}: chmod {remedy} {file}"
    )
    file.chmod(0o644)
    file.parent.chmod(0o757)
    assert own_rights().why == f"{file}: {file.parent} is writable by everyone: chmod o-w {file.parent}"


@pytest.mark.skipif(os.getuid() != 0, reason="only root can give a file away")
def test_a_file_of_somebody_else_is_refused_also_behind_a_link(file: Path) -> None:
    write(file, f'[setup]\nusers = ["{own_user()}"]')
    target = file.with_name("target.toml")
    file.rename(target)
    file.symlink_to(target)
    assert own_rights().right is Right.SETUP
    os.chown(target, 65534, 65534)
    assert own_rights().why == f"{file}: {target} is not owned by root: chown root {target}"
    os.chown(target, 0, 0)
    os.chown(file, 65534, 65534, follow_symlinks=False)
    assert own_rights().why == f"{file}: {file} is not owned by root: chown -h root {file}"


def test_no_configuration_widens_it_and_it_may_narrow(file: Path) -> None:
    write(file, "")
    assert permissions_of(Config(operator=Operator(name="root", armed=True))).right is Right.VIEW
    assert permissions_of(Config(operator=Operator(read_only=True))).read_only


def test_no_variable_of_the_environment_counts(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(file, '[setup]\nusers = ["someone"]\ngroups = ["someone"]')
    for name in ("USER", "LOGNAME", "LNAME", "USERNAME", "SUDO_USER", "HOME"):
        monkeypatch.setenv(name, "someone")
    assert own_rights().right is Right.VIEW


def test_the_place_is_fixed_and_its_owner_is_root() -> None:
    source = Path(rights.__file__).read_text()
    assert 'FILE = Path("/etc/fleet-tui/rights.toml")' in source and (rights.OWNER, trust.ROOT) == (0, 0)
    assert "os.environ" not in source and "getenv" not in source


def test_a_user_without_a_name_goes_by_its_number(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("os.getuid", lambda: 4_000_000)
    monkeypatch.setattr("os.getgroups", lambda: [4_000_001])
    assert own_user() == "4000000" and "4000001" not in own_groups()


def test_a_link_to_nowhere_is_no_missing_file(file: Path) -> None:
    file.unlink(missing_ok=True)
    file.symlink_to(file.parent / "gone.toml")
    assert own_rights().right is Right.VIEW and "does not exist" in own_rights().why
