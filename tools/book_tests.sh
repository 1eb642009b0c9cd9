#!/usr/bin/env bash
# Lists the tests that have a page in the validation book, found in the sources: one line a test, "folder Suite.Name".
# A page belongs to the TEST in whose body it is declared. Slow tests are left out, and the tests of the book itself.
set -euo pipefail
cd "$(dirname "$0")/.."
find tests -name '*_test.cpp' -not -path 'tests/book/*' | sort | xargs awk '
  FNR == 1 { test = "" }
  /^TEST(_F|_P)?\(/ {
    test = $0
    while (test !~ /\)/ && (getline more) > 0) test = test more
    sub(/^TEST(_F|_P)?\(/, "", test); sub(/\).*/, "", test); gsub(/[ \t]/, "", test); sub(/,/, ".", test)
  }
  /^}/ { test = "" }
  /book::Page [a-z_]+[({]/ {
    if (test == "") {
      print "error: " FILENAME ":" FNR ": a page of the book must stand in the body of its test" > "/dev/stderr"
      faults = 1
    } else {
      split(FILENAME, part, "/")
      print part[2], test
    }
  }
  END { exit faults }'
