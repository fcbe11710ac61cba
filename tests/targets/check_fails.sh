#!/usr/bin/env bash
# check_fails.sh TABLE: tables that differ from TABLE in one way each; a difference that `check` lets pass, or does not
# name, fails here.
set -euo pipefail
check=$(dirname "${BASH_SOURCE[0]}")/check
table=$1
changed=$(mktemp)
trap 'rm -f "$changed"' EXIT
failed=0

# says STATUS TEXT COMMAND...; `few` is --few or nothing.
few=()
says() {
  local expected_status=$1 text=$2 status=0 output
  shift 2
  output=$("$check" "${few[@]}" "$table" "$@" 2>&1) || status=$?
  if [ "$status" -ne "$expected_status" ] || ! grep -qF -- "$text" <<<"$output"; then
    echo "check should end with $expected_status and say \"$text\"; it ended with $status and said: $output"
    failed=1
  fi
}

first=$(awk -F, 'NR == 2 { print $1 }' "$table")
last=$(awk -F, 'END { print $1 }' "$table")
says 0 " cases are equal" cat "$table"

# Every column of the last case, one after the other.
columns=$(awk -F, 'NR == 1 { print NF }' "$table")
for ((column = 2; column <= columns; ++column)); do
  name=$(awk -F, -v c="$column" 'NR == 1 { print $c }' "$table")
  awk -F, -v OFS=, -v c="$column" -v last="$last" '$1 == last { $c = $c "7" } { print }' "$table" >"$changed"
  says 1 "$last: $name is " cat "$changed"
done

grep -vF "$first," "$table" >"$changed"
says 1 "$first: the program does not print it" cat "$changed"
{ cat "$table"; sed -n '2s/^/another_/p' "$table"; } >"$changed"
says 1 "another_$first: not in the table" cat "$changed"
{ cat "$table"; tail -n 1 "$table"; } >"$changed"
says 1 "$last: printed twice" cat "$changed"
sed '1s/crc32/crc/' "$table" >"$changed"
says 1 "instead of the columns" cat "$changed"
{ head -n 5 "$table"; echo "fault: something"; } >"$changed"
says 1 "no line of the table: fault: something" cat "$changed"
says 1 "$last: the program does not print it" true
says 2 "the expected table is empty" "$check" /dev/null cat "$table"
says 2 "ended with status 3" bash -c "cat '$table'; exit 3"

few=(--few)
says 0 "12 cases are equal" head -n 13 "$table"
says 1 "the program prints 5 cases, not at least" head -n 6 "$table"
says 1 "another_$first: not in the table" sed '2s/^/another_/' "$table"

exit "$failed"
