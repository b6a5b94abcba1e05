"""The `completion` command. Its script asks this program at each Tab: it knows every command and option."""

import click
from click.shell_completion import BashComplete, add_completion_class, get_completion_class

from fleet_tui.cli.options import ExampleCommand

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


@click.command(cls=ExampleCommand)
@click.argument("shell", type=click.Choice(SHELLS), required=False)
@click.pass_context
def completion(ctx: click.Context, shell: str | None) -> None:
    """Print a script for completion in your shell. Tab then completes commands, options and names.

    \b
    bash: echo 'source <(fleet-tui completion bash)' >> ~/.bashrc
    zsh:  mkdir -p ~/.zfunc
          fleet-tui completion zsh > ~/.zfunc/_fleet-tui    (~/.zfunc in fpath)
    fish: mkdir -p ~/.config/fish/completions
          fleet-tui completion fish > ~/.config/fish/completions/fleet-tui.fish

    New shells use it. More: fleet-tui docs cli.
    """
    if shell is None:
        raise click.UsageError("which shell? fleet-tui completion bash, zsh or fish")
    found = get_completion_class(shell)
    assert found is not None
    click.echo(found(ctx.find_root().command, {}, PROGRAM, VARIABLE).source())
