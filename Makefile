# A thin face over the CMake presets: see CMakePresets.json. A target installs the Debian packages that it needs first.
PRESET ?= $(if $(CI),ci,release)
BUILD := build/$(if $(filter ci,$(PRESET)),release,$(PRESET))
JOBS ?= $(shell nproc)
SUDO := $(if $(filter 0,$(shell id -u)),,sudo)

# $(call install,LISTS): installs the packages of packages/LIST.txt that neither are installed nor come with another.
install = @there=$$(dpkg-query -W -f '$${db:Status-Status} $${Package} $${Provides}\n' | sed -n 's/^installed //p' | tr ' ,' '\n\n'); \
	missing=$$(for p in $(shell sed 's/\#.*//' $(1:%=packages/%.txt)); do printf '%s\n' $$there | grep -qx -- $$p || echo $$p; done); \
	if [ -n "$$missing" ]; then \
	  $(SUDO) apt-get update -q && $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $$missing; \
	fi

.DEFAULT_GOAL := help
.PHONY: help fly build test test-long bench lint docs deps program-deps all clean

help:  ## Print this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "make %-10s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

fly: build  ## Take off, hover and land; the flight directory is out/takeoff_hover_land
	$(BUILD)/touchdown fly scenarios/flights/takeoff_hover_land.yaml

build: program-deps  ## Build the program, build/release/touchdown, and no test
	cmake --preset $(PRESET) $(if $(wildcard $(BUILD)/CMakeCache.txt),,-D TOUCHDOWN_TESTS=OFF)
	cmake --build --preset $(PRESET) -j $(JOBS) --target touchdown

test: all  ## Build everything and run every test but the long ones
	ctest --preset $(PRESET) -j $(JOBS) -LE long

test-long: all  ## Run the tests that take longer: every experiment of the paper, in brief
	ctest --preset $(PRESET) -j $(JOBS) -L long

bench: all  ## Measure the cost of vision beside AprilTag 3, of rendering and of the loop, on the same frames
	$(BUILD)/tests/benchmarks

lint: deps  ## Run clang-tidy; a warning is an error
	cmake --preset lint
	run-clang-tidy -quiet -j $(JOBS) -p build/lint '^$(CURDIR)/(models|sim|estimator|controller|scenarios|tests)/.*\.cc$$'

docs: deps  ## Make the API pages from the headers, build/docs/html; a broken reference is an error
	mkdir -p build/docs
	doxygen docs/Doxyfile

deps:  ## Install every package of packages/
	$(call install,build run test)

program-deps:
	$(call install,build run)

all: deps
	cmake --preset $(PRESET) -D TOUCHDOWN_TESTS=ON
	cmake --build --preset $(PRESET) -j $(JOBS)

clean:  ## Remove build/
	rm -rf build
