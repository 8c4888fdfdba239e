PYTHON ?= python3
BIN := .venv/bin
STAMP := .venv/.installed

COMPILE := uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header --no-annotate --no-strip-extras --group model

.PHONY: setup demo docs test test-clients lint bench lock dist

setup: $(STAMP)

$(STAMP): requirements.lock pyproject.toml
	@$(PYTHON) preflight.py
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@$(BIN)/python -m compileall -q c4s cases catalog flows reports tasks warehouse
	@touch $(STAMP)

demo: setup
	@$(BIN)/c4s demo

docs: setup
	@$(BIN)/python -m manual --out .c4s/manual

test: setup
	$(BIN)/python -m pytest --numprocesses auto --dist loadscope

test-clients: setup
	$(BIN)/python tests/agent_clients/matrix.py --install
	$(BIN)/python tests/agent_clients/received.py
	$(BIN)/python tests/agent_clients/behaviour.py
	$(BIN)/python tests/agent_clients/connected.py
	$(BIN)/python tests/agent_clients/harness.py --install

lint: setup
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: setup
	$(BIN)/python -m bench

dist: setup
	@$(BIN)/python -m bench.dist

lock:
	$(COMPILE) --extra dev pyproject.toml -o requirements.lock
	$(COMPILE) --constraints requirements.lock pyproject.toml -o requirements-run.lock
