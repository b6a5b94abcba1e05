# `make demo` and `make test` set up what they need in .venv; nothing else is touched.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
PURE := $(addprefix tests/,text model keys orders situation commands robots state maps/formats ui/view config features/graphs/rules features/routines/rules test_house.py)
# Twice the cores: some wait for a process. The longest first.
TOGETHER := -q --forks $(shell expr $$(getconf _NPROCESSORS_ONLN) \* 2)
POS := $(wildcard fleet_tui/locales/*/LC_MESSAGES/fleet_tui.po)
CATALOGUES := $(POS:.po=.mo)
# Compiled once, not by each of a few hundred processes.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo messages test nightly quick lint types unit bench coverage faults typed kills advisories fuzz soak pictures docs lock format dist dist-check clean

$(CATALOGUES): $(READY) $(POS)
	@$(BIN)/python hatch_build.py

# The messages of the code into each catalogue, for their translations.
messages: $(READY)
	@$(BIN)/pybabel -q extract -F babel.cfg -k "Message tr N_ counted:1,2" --no-wrap --no-location -o $(VENV)/messages.pot .
	@for po in $(POS); do $(BIN)/pybabel -q update --no-wrap --ignore-obsolete --no-fuzzy-matching -i $(VENV)/messages.pot -d fleet_tui/locales -D fleet_tui -l $$(basename $$(dirname $$(dirname $$po))); done

demo: $(READY) $(CATALOGUES)
	@$(BIN)/fleet-tui demo

test: $(READY) $(CATALOGUES)
	@$(MAKE) --no-print-directory -j 2 lint types unit

lint: $(READY)
	@$(BIN)/ruff format --check --quiet . || { echo "run: make format"; exit 1; }
	@$(BIN)/ruff check --quiet .
	@$(BIN)/lint-imports --no-logo

types: $(READY)
	@$(BIN)/mypy

# The developer's loop: no processes, no sockets.
quick: $(READY) $(CATALOGUES)
	@$(BIN)/pytest -q --forks 2 $(PURE)

unit: $(READY) $(CATALOGUES)
	@$(BIN)/pytest $(TOGETHER)

# All that takes too long for each commit: the tests marked so, 2,000 examples of each pure property, random keys,
# kills, an hour's load in minutes, fuzzing, figures. Hours; each part ends by itself, and the first failure ends it.
nightly: $(READY)
	@$(BIN)/pytest $(TOGETHER) -m nightly --ignore tests/faults
	@FLEET_TUI_EXAMPLES=$(or $(EXAMPLES),2000) $(BIN)/pytest -q --forks 2 --timeout 0 $(PURE)
	@$(MAKE) --no-print-directory coverage faults kills soak fuzz bench
	@$(MAKE) --no-print-directory typed SEQUENCES=2000

bench: $(READY)
	@sed -n 's/^\([^ #]*==[^ ]*\).*/\1/p' requirements.lock > $(VENV)/constraints.txt
	@$(BIN)/pip install --quiet --disable-pip-version-check -c $(VENV)/constraints.txt -e '.[bench]' || echo "measuring without the others"
	@$(BIN)/python -m tests.bench --json docs/performance.json

# Lines and branches that make test and the faults run, per package: none may fall below its figure.
coverage: $(READY)
	@$(BIN)/pip install --quiet --disable-pip-version-check 'pytest-cov>=6,<8'
	@$(BIN)/pytest $(TOGETHER) --cov=fleet_tui --cov-branch --cov-report=
	@$(BIN)/pytest $(TOGETHER) -m nightly tests/faults --cov=fleet_tui --cov-branch --cov-append --cov-report=json:$(VENV)/coverage.json
	@$(BIN)/python -m tests.support.coverage_floors $(VENV)/coverage.json tests/coverage_floors.toml

soak: $(READY)
	@$(BIN)/python -m tests.bench.soak --minutes $(or $(MINUTES),30)

faults: $(READY)
	@rm -f $(VENV)/faults.jsonl
	@FLEET_TUI_FAULTS=$(CURDIR)/$(VENV)/faults.jsonl $(BIN)/pytest -m '' $(TOGETHER) tests/faults
	@$(BIN)/python -m tests.support.fault_report $(VENV)/faults.jsonl docs/faults.md

# Random keys in every form, list and menu: nothing leaves that nobody meant.
typed: $(READY)
	@FLEET_TUI_SEQUENCES=$(or $(SEQUENCES),10000) $(BIN)/pytest -q --forks 2 --timeout 0 tests/scenarios/test_typed_at_random.py

# Each console is killed as its command reaches the robot: its audit log has the command. 1.5 s each.
kills: $(READY)
	@FLEET_TUI_KILLS=$(or $(KILLS),500) $(BIN)/pytest -m '' -q tests/faults/test_kills.py

# Coverage-guided, and no part of the tests: atheris has no wheels for some systems.
fuzz: $(READY)
	@$(BIN)/pip install --quiet --disable-pip-version-check atheris
	@$(BIN)/python -m tests.fuzz -max_total_time=$(or $(SECONDS),60) -rss_limit_mb=1500 -timeout=20 -artifact_prefix=$(VENV)/

format: $(READY)
	@$(BIN)/ruff format .
	@$(BIN)/ruff check --fix .

# What pip does, on one line of a terminal.
PROGRESS = while read -r did what _; do \
  case $$did in Collecting) n=$$((n + 1)) ;; Installing) what="installing all ..." ;; *) continue ;; esac; \
  if test -t 1; then printf '\r\033[K  %d of %d: %s' "$$n" "$$(grep -c == requirements.lock)" "$$what"; fi; \
done; if test -t 1; then printf '\r\033[K'; fi

$(READY): SHELL := bash
$(READY): pyproject.toml requirements.lock
	@echo "Setting up $(VENV) (once, half a minute or more) ..."
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Python 3.11 or newer is needed; say which with: make PYTHON=python3.12 ..."; exit 1; }
	@$(PYTHON) -m venv $(VENV)
	@set -o pipefail; PYTHONUNBUFFERED=1 $(BIN)/pip install --disable-pip-version-check --require-hashes -r requirements.lock | { $(PROGRESS); }
	@$(BIN)/pip install --quiet --disable-pip-version-check --no-deps -e .
	@touch $@
	@echo "Ready."

# Needs Xvfb, xterm and xdotool: pictures of a real terminal.
pictures: $(READY)
	@$(BIN)/python docs/pictures.py states build/pictures && echo "look at build/pictures"

docs: $(READY)
	@$(BIN)/python docs/pictures.py docs

# The versions that were tested, with the Python of .venv: needs a network.
dist: $(READY)
	@$(BIN)/python -m release.build

# Says which dependencies have known advisories, at their floors and as locked; needs a network, and fails nothing.
advisories: $(READY)
	@$(BIN)/python -m release.advisories

dist-check: $(READY)
	@$(BIN)/python -m release.check

lock:
	@rm -rf $(VENV)/lock && $(PYTHON) -m venv $(VENV)/lock
	@$(VENV)/lock/bin/pip install --quiet --disable-pip-version-check uv
	@$(VENV)/lock/bin/uv pip compile --quiet --generate-hashes --no-annotate --no-header --no-emit-index-url --no-emit-find-links --extra dev pyproject.toml > $(VENV)/pins
	@(echo "# Exact versions that were tested, with the hashes of their files; made by: make lock"; cat $(VENV)/pins) > requirements.lock

clean:
	rm -rf $(VENV) build dist
