# Wrapper of the CMake presets (CMakePresets.json). Each target first installs the Debian packages that it needs.
PRESET ?= $(if $(CI),ci,release)
BUILD := build/$(if $(filter ci,$(PRESET)),release,$(PRESET))
JOBS ?= $(shell nproc)
SUDO := $(if $(filter 0,$(shell id -u)),,sudo)

# $(call install,LISTS): installs the packages of packages/LIST.txt that are neither installed nor provided by another
# package.
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

build: program-deps  ## Build the program only, build/release/touchdown
	cmake --preset $(PRESET) $(if $(wildcard $(BUILD)/CMakeCache.txt),,-D TOUCHDOWN_TESTS=OFF)
	cmake --build --preset $(PRESET) -j $(JOBS) --target touchdown

test: all  ## Build everything and run all tests but the long ones
	ctest --preset $(PRESET) -j $(JOBS) -LE long

test-long: all  ## Run the long tests: all experiments of the paper on few samples
	ctest --preset $(PRESET) -j $(JOBS) -L long

bench: all  ## Measure vision, rendering and the loop, and AprilTag 3 on the same frames
	$(BUILD)/tests/benchmarks

lint: deps  ## Run clang-tidy on all sources; a warning is an error
	cmake --preset lint
	cmake --build build/lint --target shipped_flights touchdown_page_assets
	run-clang-tidy -quiet -j $(JOBS) -p build/lint '\.(cc|cxx)$$'

docs: deps  ## Write API pages to build/docs/html; a broken reference is an error
	mkdir -p build/docs
	doxygen docs/Doxyfile

deps:  ## Install all packages of packages/
	$(call install,build run test)

program-deps:
	$(call install,build run)

all: deps
	cmake --preset $(PRESET) -D TOUCHDOWN_TESTS=ON
	cmake --build --preset $(PRESET) -j $(JOBS)

clean:  ## Remove build/
	rm -rf build
