# Two commands: `make demo` builds a B-train, `make test` runs every check. Both install what they need into .venv.
PYTHON ?= $(shell for p in python3 python3.13 python3.12 python3.11; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$p && break; done)
BIN := .venv/bin
VEHICLE := vehicles/b_train.yaml

.PHONY: demo test lint docs pictures clean

demo: .venv/installed
	$(BIN)/eom check $(VEHICLE) --set U=110km/h
	@echo
	$(BIN)/eom modes $(VEHICLE) --set U=110km/h
	@echo
	$(BIN)/eom build $(VEHICLE) --set U=110km/h --out build
	@echo
	$(BIN)/python tools/module_lane_change.py build/b_train.py build/b_train.png
	@echo
	$(BIN)/eom simulate $(VEHICLE) --run vehicles/runs/lane_change.yaml --out build

# on all cores, a file's tests on one of them: they share what they build
test: lint docs
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto --dist loadfile

lint: .venv/developing
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

docs: .venv/developing
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet --strict --site-dir build/site

# the figures of README and docs
pictures: .venv/installed
	$(BIN)/eom build $(VEHICLE) --set U=110km/h --out build
	$(BIN)/python tools/module_lane_change.py build/b_train.py docs/images/b_train_module.png
	$(BIN)/python tools/lane_change.py docs/images/b_train_lane_change.png
	$(BIN)/eom build vehicles/b_train_yaw_roll.yaml --set U=110km/h --out build
	$(BIN)/python tools/steer_response.py build/b_train_yaw_roll.py docs/images/b_train_steer_response.png
	mkdir -p build
	sed -n '/^name: B-train/,/^```$$/p' docs/b-train.md | sed '$$d' > build/b_train.yaml
	$(BIN)/eom response build/b_train.yaml --output lead.ay/tractor.ay --output second.ay/tractor.ay \
		--from 0.05 --to 2 --out docs/images
	$(BIN)/eom response vehicles/full_car.yaml --output bounce --output pitch --output roll \
		--output bounce_acceleration --road C --out docs/images
	$(BIN)/eom sweep vehicles/bicycle.yaml U=0.5:10:0.1m/s --out docs/images
	$(BIN)/eom sweep vehicles/motorcycle.yaml U=2:65:0.5m/s --out docs/images
	$(BIN)/eom sweep vehicles/car_trailer.yaml U=40:180:5km/h ahead=-0.4:0.6:0.05m --out docs/images
	$(BIN)/eom tyre vehicles/tyres/passenger_car.tir --out docs/images
	$(BIN)/eom simulate $(VEHICLE) --run vehicles/runs/lane_change.yaml \
		--input axle_1.steer=sine:3.58deg:0.4Hz:0.5s --duration 6s --out build
	cp build/b_train_run.png docs/images/lane_change_run.png
	rm -f docs/images/*.csv docs/images/*.svg docs/images/full_car_frequency.png

clean:
	rm -rf build .venv

.venv/installed: pyproject.toml
	@test -n "$(PYTHON)" || { echo "eom needs Python 3.11 or newer"; exit 1; }
	@echo "installing into .venv ..."
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[fast]'
	@touch $@

.venv/developing: .venv/installed
	@echo "installing the tools for development into .venv ..."
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev,fast,referees]'
	@touch $@
