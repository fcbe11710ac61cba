#!/usr/bin/env bash
# words.sh ROOT: comments, documents and names use the terms of the field. It refuses words for persons where code, pixels
# or buses are meant; limits whose names do not begin with kMax or kMin; comments that begin with a word that leaves out
# the subject; rare words for common ones; lines of prose that reach column 120.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/search.sh"
cd "$1"
failed=0

complain() {
  printf '%s:\n%s\n' "$1" "$2"
  failed=1
}

places=(core hal firmware host-sim docs cmake README.md)

# A table of docs/design.md has old terms and their successors.
lines -rnIiwE 'nobody|whoever|somebody|someone|anybody|surroundings' "${places[@]}"
lines -v '^docs/design.md:[0-9]*:| ' <<<"$found"
if [ -n "$found" ]; then complain "not a term of the field" "$found"; fi

lines -rnIE '\bk(Most|Largest|Least)([A-Z]\w*)?\b' "${places[@]}"
lines -v '^docs/design.md:[0-9]*:| ' <<<"$found"
if [ -n "$found" ]; then complain "limits begin with kMax or kMin" "$found"; fi

lines -rnIE --include='*.cpp' --include='*.hpp' --include='*.h' --include='*.ino' --include='*.mjs' --include='*.js' \
  '(^|[ ;,{})])(///?<?|/\*\*) *(Of|What|Whether|Those|Likewise)\b' core hal firmware host-sim
if [ -n "$found" ]; then complain "a comment without a subject: say what the thing is or does" "$found"; fi

lines -rnIiwE 'seldom|quicker|quickest|dearer' "${places[@]}"
if [ -n "$found" ]; then complain "rare, faster, fastest, more expensive" "$found"; fi

# Rows of tables, code and images stand on one line. Measured pages are written by programs.
found=$(find . \( -path ./.git -o -path './build*' -o -path ./out -o -path ./docs/measured -o -name CHANGELOG.md \) -prune -o \
  -name '*.md' -print0 | sort -z | LC_ALL=C xargs -0 -r awk '
  FNR == 1 { code = 0 }
  /^ *```/ { code = !code; next }
  { characters = $0; gsub(/[\200-\277]/, "", characters) }
  !code && !/^ *(\||!\[|<!--)/ && length(characters) > 119 { print FILENAME ":" FNR ": " $0 }')
if [ -n "$found" ]; then complain "prose that reaches column 120" "$found"; fi

exit "$failed"
