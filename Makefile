# make taylor   the main job: the copper cylinder by MPM and by FEM; prints a table and the path of the report
# make necking  a bar pulled until it necks, by several methods; prints verdicts and the path of the report
# make gallery  docs/gallery.md and its pictures, drawn anew from the studies, when every number in it holds
# make test     the tests
# make setup    only the set-up, which the others do by themselves
# make lint     style and format of the sources
# make clean    remove everything that make has made

PYTHON ?= python3
EXTRAS ?= dev,view
VENV := .venv
READY := $(VENV)/ready

.PHONY: taylor necking gallery test setup lint clean

taylor: $(READY)
	rm -rf results/taylor
	$(VENV)/bin/matpoint compare taylor-copper-jc --out results/taylor

necking: $(READY)
	rm -rf results/necking
	$(VENV)/bin/matpoint study necking --out results/necking

gallery: $(READY)
	$(VENV)/bin/python -m studies.gallery docs

test: $(READY)
	$(VENV)/bin/python -m pytest -n 2 --dist loadfile

setup: $(READY)

lint: $(READY)
	$(VENV)/bin/ruff check .
	$(VENV)/bin/ruff format --check .

clean:
	rm -rf $(VENV) results build dist *.egg-info .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# The stamp is older than the files that decide what is installed whenever one of them was edited.
$(READY): pyproject.toml constraints.txt setup/system_libraries.py
	$(PYTHON) setup/system_libraries.py
	$(PYTHON) -m venv $(VENV)
	$(VENV)/bin/python -m pip install --quiet --disable-pip-version-check \
		--constraint constraints.txt --editable '.[$(EXTRAS)]'
	touch $@
