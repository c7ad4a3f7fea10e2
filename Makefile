# A thin face over the CMake presets: see CMakePresets.json. Every target installs what is missing first.
PRESET ?= $(if $(CI),ci,release)
BUILD := build/$(if $(filter ci,$(PRESET)),release,$(PRESET))
JOBS ?= $(shell nproc)
SEEDS ?= $(shell seq 1 20)
PACKAGES := $(shell sed 's/\#.*//' packages.txt)
SUDO := $(if $(filter 0,$(shell id -u)),,sudo)

.PHONY: fly test build deps bench acceptance lint clean

fly: build  ## Take off, hover and land; the flight's folder is left in out/takeoff_hover_land
	$(BUILD)/touchdown fly scenarios/flights/takeoff_hover_land.yaml

test: build  ## Every test
	ctest --preset $(PRESET) -j $(JOBS)

build: deps
	cmake --preset $(PRESET)
	cmake --build --preset $(PRESET) -j $(JOBS)

deps:  ## Install the packages of packages.txt that neither are installed nor come with another
	@there=$$(dpkg-query -W -f '$${db:Status-Status} $${Package} $${Provides}\n' | sed -n 's/^installed //p' | tr ' ,' '\n\n'); \
	missing=$$(for p in $(PACKAGES); do printf '%s\n' $$there | grep -qx -- $$p || echo $$p; done); \
	if [ -n "$$missing" ]; then \
	  $(SUDO) apt-get update -q && $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $$missing; \
	fi

bench: build  ## Cost of vision beside AprilTag 3, of rendering and of the loop, on the same frames
	$(BUILD)/tests/benchmarks

acceptance: build  ## Every flight for each of SEEDS, and their table beside the paper's
	tests/acceptance.sh $(BUILD)/touchdown out/acceptance $(JOBS) $(SEEDS)

lint: build  ## clang-tidy's naming and bug rules
	run-clang-tidy -quiet -p $(BUILD) '\.cc$$'

clean:
	rm -rf build
