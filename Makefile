# Everything a developer or an operator runs. `make run` and `make test` need nothing but
# Python 3.11 or newer with venv, and make.

HOST ?= 127.0.0.1
PORT ?= 8000
PYTHON ?= python3
BIN := .venv/bin

.DEFAULT_GOAL := help
.PHONY: help run test lint types unit page node chromium

help:  ## list the commands
	@awk -F ':.*## ' '/^[a-z]+:.*## / { printf "make %-10s %s\n", $$1, $$2 }' Makefile

.venv/run: pyproject.toml
	@$(PYTHON) -c 'import ensurepip' || { echo "Python lacks venv: install the package python3-venv"; exit 1; }
	$(PYTHON) -m venv .venv
	$(BIN)/pip install --quiet --disable-pip-version-check .
	$(BIN)/pip uninstall --quiet --yes khv-calc
	@touch $@

.venv/test: .venv/run
	$(BIN)/pip install --quiet --disable-pip-version-check '.[test]'
	$(BIN)/pip uninstall --quiet --yes khv-calc
	@touch $@

run: .venv/run  ## start the service on http://127.0.0.1:8000
	@echo "KHV Calc: http://$(HOST):$(PORT) (the page), http://$(HOST):$(PORT)/docs (the API)"
	@exec $(BIN)/uvicorn app.main:app --host $(HOST) --port $(PORT) --no-server-header

test: lint types unit node page  ## run everything: style, types, imports, tests, page
	@echo "make test: everything passed"

lint: .venv/test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	PYTHONPATH=. $(BIN)/lint-imports --no-cache

types: .venv/test
	$(BIN)/mypy

unit: .venv/test
	$(BIN)/pytest -n auto -m "not browser"

node:
	@tests/tools.sh node nodejs
	@if command -v node >/dev/null; then node --test 'tests/static/*.test.mjs'; fi

page: .venv/test
	@tests/tools.sh chromium chromium fonts-dejavu-core
	$(BIN)/pytest -m browser tests/browser
