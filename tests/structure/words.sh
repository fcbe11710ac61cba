#!/usr/bin/env bash
# words.sh ROOT: comments, documents and names in the terms of the field. Words for persons where code, pixels or buses
# are meant; other names for what begins with kMax or kMin; lines of prose that reach column 120.
set -euo pipefail
cd "$1"
failed=0

complain() {
  printf '%s:\n%s\n' "$1" "$2"
  failed=1
}

places=()
for place in core hal firmware host-sim docs cmake README.md; do
  if [ -e "$place" ]; then places+=("$place"); fi
done

# A table of docs/design.md has old terms and their successors.
found=$(grep -rnIiwE 'nobody|whoever|somebody|someone|anybody|surroundings' "${places[@]}" | grep -v '^docs/design.md:[0-9]*:| ' || true)
if [ -n "$found" ]; then complain "not a term of the field" "$found"; fi

found=$(grep -rnIE '\bk(Most|Largest|Least)([A-Z]\w*)?\b' "${places[@]}" | grep -v '^docs/design.md:[0-9]*:| ' || true)
if [ -n "$found" ]; then complain "limits begin with kMax or kMin" "$found"; fi

# Rows of tables, code and images stand on one line. Measured pages are written by programs.
found=$(find . \( -path ./.git -o -path './build*' -o -path ./out -o -path ./docs/measured -o -name CHANGELOG.md \) -prune -o \
  -name '*.md' -print0 | sort -z | LC_ALL=C xargs -0 -r awk '
  FNR == 1 { code = 0 }
  /^ *```/ { code = !code; next }
  { characters = $0; gsub(/[\200-\277]/, "", characters) }
  !code && !/^ *(\||!\[|<!--)/ && length(characters) > 119 { print FILENAME ":" FNR ": " $0 }')
if [ -n "$found" ]; then complain "prose that reaches column 120" "$found"; fi

exit "$failed"
