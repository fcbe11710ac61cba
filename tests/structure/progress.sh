#!/usr/bin/env bash
# progress.sh ROOT: what zstrip_quietly prints while a build runs: nothing in the first second, then what is done; into
# a file seldom a line with ninja's steps, on a terminal one line that is rewritten.
set -euo pipefail
root=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0
mkdir -p "$tree"/{cmake,build}
cp "$root"/cmake/zstrip_build.sh "$tree/cmake"
unset CI

complain() {
  printf '%s: %s\n' "$1" "$(tr '\r\033' '<^' <<<"$2")"
  failed=1
}

# A program that takes three seconds and a half, with ninja's lines.
cat >"$tree/build.sh" <<'END'
for step in 1 2 3 4 5 6 7; do
  echo "[$step/7] Building CXX object"
  echo "a warning of 1 line"
  sleep 0.5
done
exit "${1-0}"
END
# builds COMMAND...: with zstrip_quietly.
cat >"$tree/builds" <<'END'
set -euo pipefail
source "$(dirname "$0")/cmake/zstrip_build.sh"
zstrip_quietly "building something" "$@"
END

output=$(bash "$tree/builds" true 2>&1)
[ -z "$output" ] || complain "what takes no second prints" "$output"

output=$(bash "$tree/builds" bash "$tree/build.sh" 2>&1)
[ "$output" = "zstrip: building something" ] || complain "not one line within 30 seconds" "$output"

output=$(ZSTRIP_PROGRESS_SECONDS=2 bash "$tree/builds" bash "$tree/build.sh" 2>&1)
grep -qxE 'zstrip: \[[1-7]/7\] building something' <<<"$output" || complain "no steps of ninja's" "$output"
[ "$(wc -l <<<"$output")" -le 2 ] || complain "more than two lines" "$output"

status=0
output=$(bash "$tree/builds" bash "$tree/build.sh" 5 2>&1) || status=$?
[ "$status" -eq 1 ] || complain "a failure ends with $status" "$output"
grep -qF "[7/7] Building CXX object" <<<"$output" || complain "a failure without its log" "$output"

if command -v script >/dev/null; then
  output=$(script -qec "bash '$tree/builds' bash '$tree/build.sh'" /dev/null </dev/null)
  [ "$(wc -l <<<"$output")" -eq 1 ] || complain "on a terminal more than one line" "$output"
  grep -qE $'\r\033\\[Kzstrip: \\[[1-7]/7\\] building something\r\033' <<<"$output" || complain "no rewritten line" "$output"
fi

# A caller that was ended leaves nothing that goes on printing.
ZSTRIP_PROGRESS_SECONDS=1 bash "$tree/builds" bash "$tree/build.sh" 2>"$tree/err" &
caller=$!
sleep 1.3
kill -KILL "$caller"
wait "$caller" 2>/dev/null || true
sleep 2.5
output=$(cat "$tree/err")
if grep -qE '\[7/7\]' <<<"$output"; then complain "prints after its caller" "$output"; fi

exit "$failed"
