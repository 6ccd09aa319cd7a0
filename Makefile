# stridemap. `make` or `make help` lists what there is; every target sets up its own .venv first.

PYTHON = python3
CONFIG = sweeps/paper.toml
OUT    = results/$(basename $(notdir $(CONFIG)))
REPORT = results/report.html
JOBS   = 2
# Empty means: the program's own default.
WORKERS =
CELLS   =
STARTS  =
ARGS    =

VENV := .venv
BIN  := $(VENV)/bin
PIP  := $(BIN)/python -m pip --disable-pip-version-check --no-input --quiet install
PIN  := $(PIP) --require-hashes --only-binary :all: --requirement
LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --fork-strategy fewest \
        --only-binary :all: --generate-hashes --no-header --no-emit-index-url --no-emit-find-links

# Set-up leaves a stamp for each of its steps and does a step again only when its input is newer.
# A .venv that was copied from elsewhere, or whose Python is gone, is made anew.
MADE := $(VENV)/made-in
RUN  := $(VENV)/installed-run
DEV  := $(VENV)/installed-dev
PICTURES := $(VENV)/installed-pictures
DOCS := $(VENV)/installed-docs
UV   := $(VENV)/installed-lock
SOUND := $(shell [ -x $(BIN)/python ] && [ "$$(cat $(MADE) 2>/dev/null)" = "$$(pwd -P)" ] && echo yes)

# Tests start some hundred processes: what one of them compiled of the source the next need not.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help derive sweep claims figures images report quick test lint format bench recall docs lock clean FORCE

help: ## this list
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "make %-8s %s\n", $$1, $$2 }' Makefile

derive: $(RUN) ## write the equations, the C and the kernels of all models into generated/
	$(BIN)/stridemap derive $(ARGS)

sweep: $(PICTURES) ## find all limit cycles of a grid, or go on with what is unfinished (CONFIG=, OUT=, WORKERS=)
	$(BIN)/stridemap sweep "$(CONFIG)" --out "$(OUT)" --resume $(if $(WORKERS),--workers $(WORKERS)) $(ARGS)

claims: $(RUN) ## decide the paper's statements by computation (WORKERS=, ARGS=--json)
	@$(BIN)/stridemap claims $(if $(WORKERS),--workers $(WORKERS)) $(ARGS)

figures: $(PICTURES) ## draw the paper's figures as SVG and PNG into results/paper-figures (WORKERS=)
	$(BIN)/stridemap figures $(if $(WORKERS),--workers $(WORKERS)) $(ARGS)

images: figures ## make the pictures of the README again, in docs/images
	$(BIN)/python docs/pictures.py

report: $(RUN) ## write the paper's map and verdicts as one HTML page to explore (WORKERS=, REPORT=)
	$(BIN)/stridemap report --out "$(REPORT)" $(if $(WORKERS),--workers $(WORKERS)) $(ARGS)

quick: $(DEV) ## run the tests that catch most faults, in under a minute (JOBS=2 at a time)
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal -m quick $(ARGS)

test: $(DEV) ## run all tests (JOBS=2 at a time; ARGS="-k word" for some)
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal $(ARGS)

lint: $(DEV) ## check style, types, imports between the layers, and that every file is packaged
	@$(BIN)/python .ci/lint.py

format: $(DEV) ## put the style in order where that can be done by program
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .

bench: $(DEV) ## measure the speed, beside the paper's practice, and how the derivation grows with the links
	$(BIN)/python -m benchmarks.bench $(ARGS)
	$(BIN)/python -m benchmarks.links $(filter --json,$(ARGS))

recall: $(DEV) ## measure what share of all limit cycles the sweep finds (CELLS=, STARTS=)
	$(BIN)/python -m benchmarks.recall $(if $(CELLS),--cells $(CELLS)) $(if $(STARTS),--starts $(STARTS)) $(ARGS)

docs: $(DOCS) ## build the pages in docs/, running every example
	$(BIN)/python -m sphinx -W --keep-going -q docs docs/_build/html $(ARGS)
	@echo "The pages are in docs/_build/html/index.html."

lock: $(UV) ## remake requirements/*.txt after a change of what is required (ARGS=--upgrade for newer versions)
	$(LOCK) $(ARGS) -o requirements/run.txt pyproject.toml requirements/build.in
	$(LOCK) $(ARGS) -o requirements/pictures.txt -c requirements/run.txt --extra pictures pyproject.toml requirements/build.in
	$(LOCK) $(ARGS) -o requirements/dev.txt -c requirements/run.txt -c requirements/pictures.txt --extra pictures pyproject.toml requirements/build.in requirements/dev.in
	$(LOCK) $(ARGS) -o requirements/docs.txt -c requirements/run.txt -c requirements/pictures.txt -c requirements/dev.txt --extra docs pyproject.toml requirements/build.in
	$(LOCK) $(ARGS) -o requirements/lock.txt requirements/lock.in

clean: ## remove .venv, what was built and every cache inside this folder; results/ stays
	rm -rf $(VENV) build dist *.egg-info docs/_build docs/gallery .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	@find . -name results -prune -o -name .git -prune -o -name __pycache__ -type d -print | while read -r d; do rm -rf "$$d"; done
	@if [ -e results ]; then echo "Kept: results/ (remove it yourself if you do not need it)."; fi

# ---- set-up ----

$(MADE): $(if $(SOUND),,FORCE)
	@command -v "$(PYTHON)" >/dev/null || { \
	  echo "stridemap needs Python 3.11 or newer, and there is no '$(PYTHON)' on the path:" \
	    "install it, or name another with 'make PYTHON=python3.12 $(MAKECMDGOALS)'." >&2; exit 1; }
	@"$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "stridemap needs Python 3.11 or newer, and '$(PYTHON)' is $$("$(PYTHON)" --version 2>&1 | tail -n 1):" \
	    "name another with 'make PYTHON=python3.12 $(MAKECMDGOALS)'." >&2; exit 1; }
	@echo "Setting up $(VENV): once, about a minute."
	@rm -rf $(VENV)
	@"$(PYTHON)" -m venv $(VENV) || { rm -rf $(VENV); \
	  echo "'$(PYTHON) -m venv' failed: on Debian and Ubuntu the package python3-venv is needed." >&2; exit 1; }
	@pwd -P > $@

$(RUN): $(MADE) requirements/run.txt pyproject.toml
	@echo "Installing what stridemap runs on (requirements/run.txt) ..."
	@$(PIN) requirements/run.txt
	@for walker in derive/models/*.py; do grep -q '^WALKER =' $$walker && mkdir -p generated/$$(basename $$walker .py); done; true # so that `make derive` works where they were removed
	@$(PIP) --no-build-isolation --no-deps --editable .
	@touch $@

$(PICTURES): $(RUN) requirements/pictures.txt
	@echo "Installing what draws (requirements/pictures.txt) ..."
	@$(PIN) requirements/pictures.txt
	@touch $@

$(DEV): $(RUN) requirements/dev.txt
	@echo "Installing what tests and checks it (requirements/dev.txt) ..."
	@$(PIN) requirements/dev.txt
	@touch $@

$(DOCS): $(RUN) requirements/docs.txt
	@echo "Installing what builds the pages (requirements/docs.txt) ..."
	@$(PIN) requirements/docs.txt
	@touch $@

$(UV): $(MADE) requirements/lock.txt
	@$(PIN) requirements/lock.txt
	@touch $@
