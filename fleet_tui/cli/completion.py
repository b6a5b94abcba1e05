"""The `completion` command. Its script asks this program at each Tab: it knows every command and option."""

import click
from click.shell_completion import BashComplete, add_completion_class, get_completion_class

PROGRAM = "fleet-tui"
VARIABLE = "_FLEET_TUI_COMPLETE"
"""Environment variable in which the script asks for values."""

SHELLS = ("bash", "zsh", "fish")


class BashWords(BashComplete):
    """Bash hands over `--option=value` as three words."""

    def get_completion_args(self) -> tuple[list[str], str]:
        """Return the words before the cursor, and the one at it."""
        words, typed = super().get_completion_args()
        return [word for word in words if word != "="], typed


add_completion_class(BashWords)


@click.command()
@click.argument("shell", type=click.Choice(SHELLS))
@click.pass_context
def completion(ctx: click.Context, shell: str) -> None:
    """Print a script for completion in your shell. Tab then completes commands, options and names.

    \b
    bash: in ~/.bashrc: source <(fleet-tui completion bash)
    zsh:  fleet-tui completion zsh > ~/.zfunc/_fleet-tui    (~/.zfunc in fpath)
    fish: fleet-tui completion fish > ~/.config/fish/completions/fleet-tui.fish

    New shells use it. More in docs/cli.md.
    """
    found = get_completion_class(shell)
    assert found is not None
    click.echo(found(ctx.find_root().command, {}, PROGRAM, VARIABLE).source())
