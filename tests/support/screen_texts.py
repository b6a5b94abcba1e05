"""The texts of the console, collected from its code: what a catalogue has to translate.

A text is what `tr` is called with, the label and the explanation of a key, the words of the values that are
shown, and every sentence in the packages that talk to the operator. In a message the values of an f-string
are places, named after them: `no link for {age}`.
"""

import ast
import re
from collections.abc import Iterable
from enum import Enum
from functools import cache
from itertools import product
from pathlib import Path

from fleet_tui.keys import HISTORY_PAGES, KEYS, PAGES, Pane
from fleet_tui.model.commands import Stage
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.order import OrderState
from fleet_tui.model.programs.program import ProgramState
from fleet_tui.model.routines.lane import BEGUN, ENDED, LEFT, SKIPPED
from fleet_tui.rules.alarms.classes import CLASSES
from fleet_tui.rules.history.observing import BEGUN as BEGAN
from fleet_tui.rules.why.reason import Strength
from fleet_tui.screens.ordering.choices import ROLES
from fleet_tui.situation import facts
from fleet_tui.view.help.pages import ALWAYS
from fleet_tui.view.help.pages import TYPED as TYPED_HELP
from fleet_tui.view.lines.history import HINTS
from fleet_tui.view.tables.alarms import PRIORITIES, SHORT_PRIORITIES, SIGNS
from fleet_tui.view.tables.doing import UNKNOWN

ROOT = Path(__file__).parent.parent.parent / "fleet_tui"
TALKING = (
    *(
        "app",
        "console",
        "situation",
        "rules",
        "model",
        "controllers",
        "keys",
        "screens",
        "view",
        "widgets",
        "adapters",
    ),
    *("client", "desk", "programs", "routines", "maps", "recording/play", "recording/recorder", "errors"),
    *("recording/recordings", "history/writer", "transports/reasons", "transports/mqtt/reasons"),
    *(
        "transports/rosbridge/reasons",
        "terminal/clipboard",
        "terminal/detect",
        "camera",
        "text/units",
        "text/limits",
    ),
)
"""Packages whose sentences reach the screen."""
SILENT = (
    *("view/report/", "view/help/synonyms", "view/tables/audit", "view/tables/arrival", "screens/first_run"),
    *("screens/arrival", "screens/before", "adapters/ros/", "adapters/registry", "adapters/service_outcome"),
    *("adapters/oh_ressources/vocabulary", "adapters/oh_ressources/reading", "adapters/oh_ressources/graphs"),
    *(
        "adapters/discovery",
        "adapters/oh_ressources/discovery",
        "adapters/ros_navigation",
        "client/rosbridge/services",
    ),
    *("adapters/move_base/reading", "adapters/move_base/probes", "adapters/nav2/reading"),
    *(
        "adapters/nav2/probes",
        "adapters/nav2/adapter",
        "rules/driving/echoes",
        "routines/units",
        "maps/saving",
    ),
)
"""Parts of them that stay English: the audit log and the report, what was wrong with a message as the log
file has it, the doctor, and the screens before a configuration is known."""
AROUND = frozenset(("sanitize", "len", "tr", "int", "round", "max", "min", "abs", "str", "join", "clock"))
"""Functions after whose argument a place is named."""
UNHEARD = frozenset(("debug", "info", "warning", "error", "exception", "compile", "TypeVar", "LOG"))
"""Functions whose texts are not shown."""
TOLD = {
    "named": (0,),
    "Value": (0,),
    "Reason": (0, 1),
    "Condition": (3, 4),
    "Fact": (2,),
    "FactKind": (1, 2),
    "Problem": (1,),
    "say": (0,),
}
"""Functions with arguments that are shown, however short: names of lines and columns, causes, alarms."""
_LABEL = re.compile("[A-Z][a-z]+")
TYPED = re.compile(
    r"[a-z-]+ [A-Z]{2,}\b.*|.*\brobot_\d.*"
    r"|(goto|set-pose|localise|settle|mapping|store-map|store-pose-graph|claim|release|cancel|clear|pause|resume"
    r"|open|carry) \{\w+\}( (on|off|goal|\{\w+\}))?"
    r"|(anyone|carry) Base .*|(name|unit|start) = .*|save(-map)? \w+\.\w+|theme, record.*"
    r"|(use battery|wait) .*|end|use \{PLAIN\}.*|Left Right.*|[\w.]+ \{[\w ]*[\w-]+: .*",
    re.DOTALL,
)
"""Texts that are typed as they are, and style sheets."""
_SENTENCE = re.compile(r"[A-Za-z]{2,}\S* |\s[A-Za-z]{2,}|\} ?[a-z]{3,}|^[a-z]{3,}: ?\{")
_PLACE = re.compile(r"\{(\w+)\}")
_UNIT = re.compile(r"\b(ms|kB|MB|px|Hz|rad/s|m/s|min|fps|km)\b")


def place_name(value: ast.expr) -> str:
    """Return the name of a place: that of the value in the code."""
    match value:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name.strip("_")
        case ast.Subscript(value=inner) | ast.BinOp(left=inner) | ast.UnaryOp(operand=inner):
            return place_name(inner)
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name), args=args):
            return place_name(args[0]) if name in AROUND and args else name.strip("_")
        case ast.IfExp(body=inner) | ast.GeneratorExp(elt=inner) | ast.BoolOp(values=[inner, *_]):
            return place_name(inner)
    return "value"


def variants(value: ast.expr) -> list[str]:
    """Return the texts that an expression may be, with places; empty if it has no text of its own. A word
    of a row of the table of facts is that word."""
    match value:
        case ast.Call(func=ast.Name(id="Message"), args=[ast.Constant(value=str(text)), *_]):
            return [text]
        case ast.Attribute(value=ast.Name(id=row), attr="word") if hasattr(facts, row):
            return [str(getattr(facts, row).word)]
        case ast.Constant(value=str(text)):
            return [text]
        case ast.JoinedStr(values=parts):
            return ["".join(made) for made in product(*map(_part, parts))]
        case ast.IfExp(body=one, orelse=other):
            return [*variants(one), *variants(other)]
        case ast.BinOp(left=one, op=ast.Mult()):
            return ["", *found] if (found := variants(one)) else []
        case ast.BinOp(left=one, op=ast.Add(), right=other) if variants(one) or variants(other):
            return ["".join(made) for made in product(*map(_part, (one, other)))]
        case ast.BoolOp(values=several):
            return [text for one in several for text in variants(one)]
    return []


def _place(value: ast.expr) -> str:
    return f"{{{place_name(value)}}}"


def _part(part: ast.expr) -> list[str]:
    value = part.value if isinstance(part, ast.FormattedValue) else part
    match value:
        case ast.Call(func=ast.Name(id="counted"), args=[count, ast.Constant(value=str(one)), *more]):
            place = _place(count)
            many = more[0].value if more and isinstance(more[0], ast.Constant) else f"{one}s"
            return [" ".join((place, noun)) for noun in (one, str(many))]
        case ast.IfExp(body=one, orelse=other):
            return [*_part(one), *_part(other)]
    return variants(value) or [_place(value)]


def message(text: str) -> str:
    """Return the message of a text: without spaces around it, each place with a name of its own."""
    seen: dict[str, int] = {}

    def numbered(place: re.Match[str]) -> str:
        name = place[1]
        seen[name] = seen.get(name, 0) + 1
        return f"{{{name}}}" if seen[name] == 1 else f"{{{name}{seen[name]}}}"

    return _PLACE.sub(numbered, text.strip())


class _Spoken(ast.NodeVisitor):
    """What a module translates, and its sentences if it `talks`."""

    def __init__(self, talks: bool) -> None:
        self.talks = talks
        self.found: list[str] = []

    def visit_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):
            self.generic_visit(node)

    def visit_arg(self, node: ast.arg) -> None:
        pass

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        for part in (*node.args.defaults, *node.args.kw_defaults, *node.body):
            if part is not None:
                self.visit(part)

    def visit_AsyncFunctionDef(self, node: ast.AsyncFunctionDef) -> None:
        for part in node.body:
            self.visit(part)

    def visit_Call(self, node: ast.Call) -> None:
        name = getattr(node.func, "attr", getattr(node.func, "id", ""))
        if name == "Message":
            self.found += variants(node)
            for value in node.keywords:
                self.visit(value.value)
        elif name == "tr":
            self.found += variants(node.args[0])
            for shown in (node.args[0], *(value.value for value in node.keywords)):
                self.visit(Calls(shown).only)
        elif name not in UNHEARD:
            for at in TOLD.get(name, ()) if self.talks else ():
                self.found += variants(node.args[at]) if at < len(node.args) else []
            self.generic_visit(node)

    def visit_Tuple(self, node: ast.Tuple) -> None:
        first = variants(node.elts[0]) if node.elts and self.talks else []
        self.found += [text for text in first if _LABEL.fullmatch(text)]
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        if not self._tell(node):
            self.generic_visit(node)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        self._tell(node)
        self.visit(Calls(node).only)

    def visit_Constant(self, node: ast.Constant) -> None:
        self._tell(node)

    def _tell(self, node: ast.expr) -> bool:
        sentences = [text for text in variants(node) if _SENTENCE.search(text)] if self.talks else []
        self.found += sentences
        return bool(sentences)


class Calls:
    """The calls within an expression, as one expression."""

    def __init__(self, node: ast.expr) -> None:
        calls = [one for one in ast.walk(node) if isinstance(one, ast.Call)]
        self.only = ast.Tuple([one for one in calls if getattr(one.func, "id", "") == "tr"])


def spoken(path: Path) -> list[str]:
    """Return the messages of a module."""
    name = path.relative_to(ROOT).as_posix()
    module = _Spoken(name.startswith(TALKING) and not name.startswith(SILENT))
    module.visit(ast.parse(path.read_text()))
    lines = (line for text in module.found for line in text.split("\n"))
    return [made for made in map(message, lines) if is_text(made)]


def is_text(made: str) -> bool:
    """Tell whether a message has words to translate."""
    return bool(re.search("[A-Za-z]{2,}", _UNIT.sub("", _PLACE.sub("", made)))) and not TYPED.fullmatch(made)


def _values(kinds: Iterable[type[Enum]]) -> set[str]:
    return {str(one.value) for kind in kinds for one in kind}


def words() -> set[str]:
    """Return the messages that are values: of keys, pages, states, classes of alarms."""
    found = {text for key in KEYS for text in (key.text, key.hint)} | {word for _, word in HINTS}
    found |= {
        *HISTORY_PAGES,
        *PAGES,
        *CLASSES,
        *SIGNS.values(),
        *PRIORITIES.values(),
        *SHORT_PRIORITIES.values(),
        UNKNOWN,
        *ROLES.values(),
    }
    found |= {one for page in PAGES.values() for one in (page.enter, *page.keys)}
    found |= {text for examples in (*TYPED_HELP.values(), ALWAYS) for _, text in examples}
    found |= _values((Pane, Stage, Activity, OrderState, ProgramState))
    found |= {one.name.lower() for one in Strength} | {BEGUN, ENDED, LEFT, SKIPPED, BEGAN}
    return set(filter(is_text, map(message, found)))


@cache
def texts() -> set[str]:
    """Return every message that a catalogue has to have."""
    return words() | {text for path in ROOT.rglob("*.py") for text in spoken(path)}
