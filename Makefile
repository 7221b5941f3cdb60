# Every target makes .venv by itself: the demo from requirements.txt alone, the tests from requirements-dev.txt, which has the same
# versions and more. PYTHON=… names another Python (3.11 or newer).
PYTHON ?= $(shell command -v python3.11 || command -v python3)
BIN := .venv/bin
INSTALLED := .venv/installed
INSTALLED_FOR_TESTS := .venv/installed-for-tests
INSTALLED_FOR_DOCS := .venv/installed-for-docs
TYPED := build/typed
PIP_QUIETLY := --quiet --disable-pip-version-check
QUICK := "not neo4j and not shared_data and not slow"
LOCKED := $(BIN)/uv pip compile pyproject.toml --universal --python-version 3.11 --upgrade --generate-hashes --no-annotate \
	--no-header --quiet

SBOM := build/sbom.cdx.json
CONSUMERS := build/consumers

MINUTES ?= 60

# Tests start hundreds of commands. Where the environment says that Python shall keep no compiled code, each would compile all of it anew.
export PYTHONDONTWRITEBYTECODE =

.PHONY: demo test test-quick check campaign soak docs mutants lock sbom clean
.DELETE_ON_ERROR:

demo: $(INSTALLED)  ## from nothing to a task tree: local Neo4j, a small FOON, a recipe that nobody recorded
	@$(BIN)/foon demo

test: $(INSTALLED_FOR_TESTS)  ## every test, against a real Neo4j
	$(BIN)/python -m pytest -n auto --durations=20

test-quick: $(INSTALLED_FOR_TESTS)  ## most tests: without a Neo4j, a browser or what takes long by itself
	$(BIN)/python -m pytest -n auto -m $(QUICK)

check: $(INSTALLED_FOR_TESTS) $(TYPED)  ## style, types, the direction of imports, how many a command makes, and that the house gets no worse
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	cd $(TYPED) && $(CURDIR)/$(BIN)/lint-imports --config $(CURDIR)/pyproject.toml
	cd $(TYPED) && $(CURDIR)/$(BIN)/mypy --config-file $(CURDIR)/pyproject.toml --cache-dir $(CURDIR)/.mypy_cache
	$(BIN)/foon plan --files foon_kg/foon/demo --dish salad "chopped onion" --quiet > $(TYPED)/salad.txt # the tables are read
	$(BIN)/python benchmarks/imports.py
	$(BIN)/python benchmarks/house.py --hold

campaign: $(INSTALLED_FOR_TESTS)  ## harm everything that can be harmed: half an hour or more
	mkdir -p $(CONSUMERS) && cp tests/campaign/consumers/* $(CONSUMERS)
	cd $(CONSUMERS) && npm ci --no-audit --no-fund --ignore-scripts --omit=optional --loglevel=error || echo "without npm: \
	what Graphviz and Mermaid make of hostile names is not looked at"
	FOON_KG_CAMPAIGN=yes $(BIN)/python -m pytest -n 4 --durations=12 tests/campaign tests/crash tests/server/test_full_disk.py \
		tests/server/test_local_server.py tests/server/test_local_server_failures.py tests/server/test_questions_of_strangers.py \
		tests/cli/test_full_disk.py tests/cli/test_collection_plans.py tests/unit/test_wheel.py tests/loaders/test_budgets.py \
		tests/web/test_connections.py tests/web/test_accessibility.py tests/web/test_api_page.py tests/web/test_teach_page.py
	FOON_KG_CAMPAIGN=yes $(BIN)/python -m pytest -n 4 -m hypothesis --ignore tests/campaign  # ten times as many examples

soak: $(INSTALLED_FOR_TESTS)  ## foon serve for an hour under mixed requests, its memory flat within a tenth; MINUTES=5 is shorter
	$(BIN)/python benchmarks/soak.py --minutes $(MINUTES)

docs: $(INSTALLED_FOR_DOCS)  ## the documents as a site, in build/docs
	$(BIN)/python docs/generate.py
	$(BIN)/python -m sphinx -b html -W --keep-going -q docs build/docs
	@echo "build/docs/index.html"

mutants: $(INSTALLED_FOR_TESTS)  ## how many mistakes made on purpose in the core the tests find: hours; MUTANTS='foon_kg.goals*' some
	$(BIN)/mutmut run $(foreach name,$(MUTANTS),'$(name)')
	$(BIN)/mutmut export-cicd-stats
	cat mutants/mutmut-cicd-stats.json

lock: $(INSTALLED)  ## write the requirements files anew from pyproject.toml, for every system
	$(BIN)/python -m pip install --quiet uv
	$(LOCKED) --extra server --extra fast --group build --output-file requirements.txt
	$(LOCKED) --extra dev --group build --constraint requirements.txt --output-file requirements-dev.txt
	$(LOCKED) --extra docs --constraint requirements-dev.txt --output-file requirements-docs.txt

# the tool has an environment of its own: what it needs is no part of foon-kg
sbom: $(INSTALLED)  ## what foon-kg is made of: every pinned package and every jar of Neo4j, in build/sbom.cdx.json (CycloneDX)
	$(PYTHON) -m venv build/sbom-tool
	build/sbom-tool/bin/python -m pip install $(PIP_QUIETLY) 'cyclonedx-bom>=7,<8'
	build/sbom-tool/bin/python -W ignore -m cyclonedx_py requirements requirements.txt --pyproject pyproject.toml \
		--output-reproducible --spec-version 1.6 --output-format JSON --output-file $(SBOM)
	$(BIN)/python -m foon_kg.store.server.sbom $(SBOM)
	build/sbom-tool/bin/python -c "import sys; from pathlib import Path; \
		from cyclonedx.schema import SchemaVersion; from cyclonedx.validation.json import JsonStrictValidator; \
		sys.exit(JsonStrictValidator(SchemaVersion.V1_6).validate_str(Path('$(SBOM)').read_text()))"
	@echo "$(SBOM)"

clean:  ## take away the environment and everything that was built
	rm -rf .venv build dist mutants .mypy_cache .pytest_cache .ruff_cache .import_linter_cache .hypothesis *.egg-info

$(INSTALLED): requirements.txt pyproject.toml
	@echo "Making .venv with everything in requirements.txt; the first time this takes a minute."
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install $(PIP_QUIETLY) --require-hashes -r requirements.txt
	$(BIN)/python -m pip install $(PIP_QUIETLY) --no-deps --no-build-isolation -e .
	@touch $@

$(INSTALLED_FOR_TESTS): requirements-dev.txt $(INSTALLED)
	@echo "Adding what the tests need, from requirements-dev.txt; the first time this takes some minutes."
	$(BIN)/python -m pip install $(PIP_QUIETLY) --require-hashes -r requirements-dev.txt
	@touch $@

$(INSTALLED_FOR_DOCS): requirements-docs.txt $(INSTALLED)
	$(BIN)/python -m pip install $(PIP_QUIETLY) --require-hashes -r requirements-docs.txt
	@touch $@

# mypy does not know that loaders/ and cypher/ are installed inside foon_kg: here they lie as they are installed
$(TYPED): FORCE
	@rm -rf $@ && mkdir -p $@/foon_kg
	@ln -s $(CURDIR)/foon_kg/* $(CURDIR)/loaders $(CURDIR)/cypher $@/foon_kg/

FORCE:
