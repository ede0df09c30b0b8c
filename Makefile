# Everything a developer or an operator runs. `make run` and `make test` need nothing but
# Python 3.11 or newer with venv, and make.

HOST ?= 127.0.0.1
PORT ?= 8000
WORKERS ?= 1
PYTHON ?= python3
BASE ?= HEAD
SEED ?= 33
BIN := .venv/bin

# What Python compiles is kept, also where a container's image says otherwise: each of the hundred
# processes that the tests start would compile it anew.
export PYTHONDONTWRITEBYTECODE :=

# Every package and what it needs, by version and hash; the service runs from the checkout.
PIP_INSTALL := $(BIN)/pip install --quiet --disable-pip-version-check
HASHED := $(PIP_INSTALL) --require-hashes --no-deps -r
COMPILE := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes \
	--no-header --no-annotate pyproject.toml

.DEFAULT_GOAL := help
.PHONY: help run check test lint types compiled fast node office accuracy catalogue compare mutations ratios house \
	bench bench-page requirements audit fuzz image soak attacks load clients picture

help:  ## list the commands
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-10s %s\n", $$1, $$2 }' Makefile

.venv/run: requirements/run.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "KHV Calc needs Python 3.11 or newer: make PYTHON=python3.12 ..."; exit 1; }
	@$(PYTHON) -c 'import ensurepip' \
		|| { echo "Python lacks venv; on Debian: apt-get install python3-venv"; exit 1; }
	$(PYTHON) -m venv .venv
	$(HASHED) requirements/run.txt
	@touch $@

.venv/test: .venv/run requirements/test.txt
	$(HASHED) requirements/test.txt
	@touch $@

run: .venv/run  ## start the service on http://127.0.0.1:8000 (HOST, PORT, WORKERS)
	@echo "KHV Calc: http://$(HOST):$(PORT) (the page), http://$(HOST):$(PORT)/docs (the API)"
	@exec $(BIN)/python -m app.serve --host $(HOST) --port $(PORT) --workers $(WORKERS)

check: .venv/test  ## what to run while working: style, types, imports, fast tests; a minute
	@$(MAKE) --no-print-directory --jobs 2 --output-sync lint types node fast \
		QUICK=--hypothesis-profile=quick

test: lint types node compiled  ## everything: check, and all that is slower, the page too
	@command -v chromium >/dev/null \
		|| tests/tools.sh chromium-headless-shell chromium-headless-shell fonts-dejavu-core
	$(BIN)/pytest --quiet --numprocesses auto --dist worksteal --maxfail 30
	@echo
	@echo "make test: style, types, imports, tests and doctests passed"
	@command -v node >/dev/null && echo "make test: the page's modules passed" \
		|| echo "make test: SKIPPED the page's modules, no node"
	@$(BIN)/python -c "from tests.inputs import chromium as c; exit(not c.path())" \
		&& echo "make test: the page in Chromium passed" \
		|| echo "make test: SKIPPED the page, no chromium"

lint: .venv/test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	PYTHONPATH=. $(BIN)/lint-imports --no-cache --no-logo

types: .venv/test
	$(BIN)/mypy

compiled: .venv/test
	@$(BIN)/python -m app.compiled

fast: compiled
	$(BIN)/pytest --quiet --numprocesses auto --dist worksteal -p no:schemathesis $(QUICK) \
		-m "not slow and not browser"

node: compiled
	@tests/tools.sh node nodejs
	@! command -v node >/dev/null || node --test tests/static/all.mjs

office: .venv/test compiled  ## files of examples by build123d, LibreCAD, LibreOffice; pictures in build/office
	$(HASHED) requirements/cad.txt
	$(HASHED) requirements/pdf.txt
	@tests/tools.sh soffice libreoffice-calc-nogui
	@tests/tools.sh librecad librecad
	@tests/tools.sh pdftoppm poppler-utils
	PYTHONPATH=. $(BIN)/python -m tests.office.sheets
	PYTHONPATH=. $(BIN)/python -m tests.office.reports build/office
	PYTHONPATH=. $(BIN)/python -m tests.office.solids
	PYTHONPATH=. $(BIN)/python -m tests.office.drawings build/office

accuracy: .venv/test  ## check stated errors and hard cases; writes docs/accuracy.md, docs/numerics.md
	PYTHONPATH=. $(BIN)/python -m benchmarks.stability
	PYTHONPATH=. $(BIN)/python -m benchmarks.front
	PYTHONPATH=. $(BIN)/python -m benchmarks.honesty
	PYTHONPATH=. $(BIN)/python -m benchmarks.pins
	PYTHONPATH=. $(BIN)/python -m benchmarks.peaks
	PYTHONPATH=. $(BIN)/python -m benchmarks.fit
	PYTHONPATH=. $(BIN)/python -m benchmarks.turns
	TIMES_AS_MANY_CASES=12 $(BIN)/pytest --quiet --numprocesses auto --dist worksteal \
		--hypothesis-profile=many tests/reference tests/core tests/app/test_fixes_reposted.py \
		tests/app/test_openapi_conformance.py tests/app/test_processes.py tests/app/test_propose_api.py

catalogue: .venv/test  ## judge reducers of catalogues and papers; writes docs/catalogue.md
	PYTHONPATH=. $(BIN)/python -m benchmarks.catalogue

compare: .venv/test  ## ask a corpus of requests of revision BASE and of this one, and compare the answers
	PYTHONPATH=. $(BIN)/python -m benchmarks.compare $(BASE)

mutations: .venv/test  ## change 60 places of revision BASE, drawn by SEED: does a test fail? An hour or two
	PYTHONPATH=. $(BIN)/python -m benchmarks.mutations $(BASE) $(SEED)

ratios: .venv/test  ## time requests and the page of this revision against those of BASE, in one run
	PYTHONPATH=. $(BIN)/python -m benchmarks.ratios $(BASE)

house: .venv/test  ## what the code weighs, the numbers of every larger change; START=1: its first start
	PYTHONPATH=. $(BIN)/python -m benchmarks.house $(if $(START),--start)

bench: .venv/test  ## time calculations and requests against each other, as ratios in one run
	PYTHONPATH=. $(BIN)/python -m benchmarks.speed
	PYTHONPATH=. $(BIN)/python -m benchmarks.sharing
	PYTHONPATH=. $(BIN)/python -m benchmarks.studio
	PYTHONPATH=. $(BIN)/python -m benchmarks.service
	PYTHONPATH=. $(BIN)/python -m benchmarks.batches
	PYTHONPATH=. $(BIN)/python -m benchmarks.proposals

bench-page: .venv/test  ## the page in Chromium: from the last key to numbers and figures, what the screen shows
	PYTHONPATH=. $(BIN)/python -m benchmarks.page
	PYTHONPATH=. $(BIN)/python -m benchmarks.frame

requirements: .venv/run  ## pin what pyproject.toml asks for, and what that needs, with hashes
	$(PIP_INSTALL) uv
	$(COMPILE) -o requirements/run.txt
	$(COMPILE) --extra dask -c requirements/run.txt -o requirements/dask.txt
	$(COMPILE) --extra test -c requirements/dask.txt -o requirements/test.txt
	$(COMPILE) --extra cad -c requirements/run.txt -o requirements/cad.txt
	$(COMPILE) --extra pdf -c requirements/run.txt -o requirements/pdf.txt

audit:  ## look for known weaknesses of the pinned packages
	@tests/audit.sh

fuzz: .venv/test  ## send 100,000 extreme, hostile and broken requests and check every answer
	PYTHONPATH=. $(BIN)/python -m benchmarks.fuzz

image:  ## build the container by buildah on a Debian base of its own, and run its health check
	@deploy/image.sh

soak: .venv/test  ## 20 minutes of mixed traffic: memory and processes, drawn in docs/soak.svg
	PYTHONPATH=. $(BIN)/python -m benchmarks.soak

attacks: .venv/test  ## repeat what has held or broken the service once, in variants; count what holds
	PYTHONPATH=. $(BIN)/python -m benchmarks.attacks

load: .venv/test  ## load the service from 1,000 connections, kill a worker, stop it; count losses
	PYTHONPATH=. $(BIN)/python -m benchmarks.load

clients: .venv/test  ## generate clients from the API's description and let them ask; needs npm
	PYTHONPATH=.:clients/python $(BIN)/python -m clients.generated

picture: .venv/test  ## take the README's picture of the page anew, in Chromium
	PYTHONPATH=. $(BIN)/python docs/picture.py
