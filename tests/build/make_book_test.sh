#!/usr/bin/env bash
# The validation book of two small pages, one that passed and one that failed; and pages that cannot be read.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/pages"

# page NAME FOUND PASSED CLAIM: theory 2, tolerance 0.1.
page() {
  cat >"$folder/pages/$1.json" <<END
{"test": "$1", "variant": "", "file": "tests/a_test.cpp", "line": 3, "chapter": "Numbers", "chapter_number": 14,
 "claim": "$4", "formula": "y = \\\\frac{a}{b}\\ny > 0", "source": "by hand",
 "symbols": [{"symbol": "a", "meaning": "a number", "unit": "m"}],
 "x": {"name": "time \$t\$", "unit": "s", "logarithmic": false},
 "y": {"name": "way", "unit": "m/s^2", "logarithmic": false}, "passed": $3,
 "series": [{"name": "", "bounded": false, "x": [1, 2], "found": [2, $2], "theory": [2, 2], "tolerance": [0.1, 0.1],
             "curve_x": [1, 2], "curve_y": [2, 2]}],
 "largest": {"deviation": 0.5, "tolerance": 0.1, "share": 5}}
END
}
fail() { echo "error: $1" >&2; exit 1; }
make_book() { (cd "$root" && tools/make_book.py "$folder/pages" "$folder/book.html" "$@"); }

page Suite.Good 2.01 true "Good < better"
make_book >/dev/null 2>"$folder/errors" || { code=$?; [ "$code" = 77 ] && exit 77; cat "$folder/errors" >&2; fail "a book of one good page ended with $code"; }
grep -q 'FAILED' "$folder/book.html" && fail "a good page is marked as failed"
grep -q 'Good &lt; better' "$folder/book.html" || fail "the claim is missing"

page Suite.Bad null false "Bad"
code=0; make_book >"$folder/log" 2>"$folder/errors" || code=$?
[ "$code" = 1 ] || fail "a book with a failed test ended with $code, expected 1"
grep -q 'id="Suite-Good"' "$folder/book.html" || fail "the good page is missing"
grep -q 'id="Suite-Bad"' "$folder/book.html" || fail "the failed page is missing"
[ "$(grep -c 'FAILED' "$folder/book.html")" = 2 ] || fail "the failed test must be marked in the summary and on its page"
[ "$(grep -o 'class="plot"' "$folder/book.html" | wc -l)" = 2 ] || fail "expected two plots"
grep -q '2 pages, 1 failed' "$folder/log" || fail "the count is missing"
grep -q 'error: failed: Suite.Bad' "$folder/errors" || fail "the failed test is not named"

rm "$folder/pages/Suite.Bad.json"
code=0; printf 'Suite.Good\nSuite.Lost\n' | make_book --expected - >/dev/null 2>"$folder/errors" || code=$?
[ "$code" = 1 ] || fail "a lost page ended with $code, expected 1"
grep -q 'Suite.Lost.*NO PAGE' "$folder/book.html" || fail "the lost page is not told in the book"

# refused TEXT MESSAGE: a page of this text, and what must be said.
refused() {
  printf '%s' "$1" >"$folder/pages/broken.json"
  code=0; make_book >/dev/null 2>"$folder/errors" || code=$?
  [ "$code" = 2 ] || fail "'$1' ended with $code, expected 2"
  grep -q "$2" "$folder/errors" || { cat "$folder/errors" >&2; fail "'$1' was not refused by '$2'"; }
}
refused '{"test": ' 'broken.json:1:10: error: no JSON'
refused '{"test": "A.B"}' 'broken.json: error: "variant" is missing'
refused "$(sed 's/"line": 3/"line": "x"/' "$folder/pages/Suite.Good.json")" '"line" is .x., expected int'
refused "$(sed 's/"theory": \[2, 2\]/"theory": [2]/' "$folder/pages/Suite.Good.json")" 'differ in length'
refused "$(sed 's/Suite.Good/Suite.Other/; s/frac{a}{b}/fraktion{a}/' "$folder/pages/Suite.Good.json")" 'formula "y = .fraktion.*not understood'
rm "$folder"/pages/*
code=0; make_book >/dev/null 2>"$folder/errors" || code=$?
[ "$code" = 2 ] && grep -q 'no page in this folder' "$folder/errors" || fail "an empty folder is to be told"
