# A thin front door over CMake: docs/building.md tells more. Everything goes to build/, results to out/.
PREFIX ?= /usr/local
JOBS ?= $(shell nproc)
BUILD := build/release

.DEFAULT_GOAL := help
.PHONY: help deps deps-view configure build run view test book bench check-all format install clean

help:  ## print this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-10s %s\n", $$1, $$2 }' Makefile

deps:  ## install the packages of packages.txt that are missing
	@tools/install_packages.sh build

deps-view:  ## install what the window needs
	@tools/install_packages.sh build view

configure: deps
	@cmake --preset release >/dev/null

build: configure  ## build the program, the libraries and the tests into build/release
	@cmake --build --preset release --parallel $(JOBS)

run: configure  ## play 60 s of the 3 versus 3 game; pictures, report and video go to out/
	@cmake --build --preset release --parallel $(JOBS) --target murosimf_app
	@$(BUILD)/murosimf run scenarios/game_3v3.toml --out out --video out/game.mp4

SCENARIO ?= scenarios/game_3v3.toml
view: deps-view  ## open a window onto SCENARIO (the 3 versus 3 game): pause, step, look at everything
	@cmake --preset release >/dev/null
	@cmake --build --preset release --parallel $(JOBS) --target murosimf-view
	@$(BUILD)/murosimf-view $(SCENARIO)

test: build  ## build and run the tests
	@ctest --preset release --parallel $(JOBS)

book: configure  ## make the validation book out/book/book.html: what tests compare with closed forms, with plots
	@tools/install_packages.sh book
	@JOBS=$(JOBS) tools/make_book.sh $(BUILD)

bench: deps  ## measure against MuJoCo, ODE and ourselves; the table goes to out/bench.json
	@tools/install_packages.sh bench || true  # without them the table says what is missing
	@cmake --preset release >/dev/null
	@cmake --build --preset release --parallel $(JOBS) --target murosimf-bench
	@$(BUILD)/murosimf-bench

check-all: deps-view  ## everything before a release: both compilers, sanitizers, clang-tidy, slow tests
	@tools/install_packages.sh build bench check
	@tools/check_all.sh

format:  ## format all C++ files
	@tools/install_packages.sh check
	@tools/check_format.sh --fix

install: configure  ## install program, headers and CMake package below PREFIX (/usr/local)
	@cmake --build --preset release --parallel $(JOBS) --target murosimf_installed
	@cmake --install $(BUILD) --prefix $(PREFIX)

clean:  ## remove build/ and out/
	@rm -rf build out
