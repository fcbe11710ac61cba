#!/usr/bin/env bash
# needed_targets.sh ROOT BUILD: tests/needed_targets knows each test that ctest has in BUILD, so that tests/run -R builds
# what it needs.
set -euo pipefail
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$1/tests/needed_targets" "$build/tests/needs.txt" "" --names | cut -f 1 | sort -u >"$work/known"
cut -f 1,2 "$build/tests/needs.txt" | awk '$1 == "test" { print $2 }' >>"$work/known"
# Without what ctest appends: parameters and types. Of tests that are registered at run time the suite is known.
ctest --test-dir "$build" -N | sed -nE 's/^ *Test +#[0-9]+: //p' | grep -v '_NOT_BUILT$' >"$work/all"
[ "$(wc -l <"$work/all")" -gt 100 ] || { echo "ctest has hardly any tests in $build"; exit 1; }
unknown=$(awk '
  NR == FNR { known[$1] = 1; next }
  {
    sub(/<.*/, "")  # a type
    name = $1
    if (name in known) next
    sub(/\/[^\/]*$/, "", name)  # a parameter
    if (name in known) next
    suite = $1; sub(/[^.]*$/, "", suite)
    if (suite in known) next
    typed = $1; sub(/\/[^\/.]*\./, ".", typed)  # Suite/Type.Name
    if (!(typed in known)) print $1
  }' "$work/known" "$work/all")
if [ -n "$unknown" ]; then
  printf 'tests/run -R would not build these; zstrip_discover_tests or zstrip_test_needs says what they need:\n%s\n' "$(head -n 20 <<<"$unknown")"
  exit 1
fi
