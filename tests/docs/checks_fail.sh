#!/usr/bin/env bash
# checks_fail.sh ROOT: check_links.py finds each thing that it looks for, the site's build ends with an error where a page
# links to a missing one or a header has a name without a comment, and pages are gathered as they are meant.
set -euo pipefail
root=$(cd "$1" && pwd -P)
check=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/check_links.py
for tool in mkdocs doxygen; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0

site=$scratch/site
mkdir "$site"
printf '<h1 id="top">a</h1><a href="other.html#there">b</a><a href="https://example.org/none">c</a>\n' >"$site/index.html"
printf '<a name="there"></a>\n' >"$site/other.html"
output=$("$check" "$site") || { echo "complains about a good page: $output"; failed=1; }

printf '%s\n' '<a href="missing.html"><a href="#here"><a href="other.html#here"><a href="../outside"><img src="a.png">' \
  '<script src="https://example.org/a.js"></script><link rel="stylesheet" href="//example.org/a.css">' >>"$site/index.html"
printf '<p>\n' >"$site/alone.html"
printf '@import "https://example.org/font.css";\n' >"$site/a.css"
if output=$("$check" "$site"); then echo "does not fail"; failed=1; fi
diff - <(sed '$d' <<<"$output") <<'EOF' || { echo "finds something else"; failed=1; }
a.css: fetches https://example.org/font.css
alone.html: no page leads here
index.html: #here: the page has no such place
index.html: ../outside leads nowhere
index.html: a.png is not there
index.html: fetches //example.org/a.css
index.html: fetches https://example.org/a.js
index.html: missing.html leads nowhere
index.html: other.html#here: the page has no such place
EOF

# A repository of one page and one header, with the rest of its folders and files empty.
mkdir -p "$scratch/tree"/{core/zstrip,docs,firmware/player/zstrip_player,hal/linux/zstrip_hal_linux,hal/zstrip_hal}
cp -r "$root/docs/site" "$scratch/tree/docs"
cd "$scratch/tree"
sed -n 's/^INPUT += //p' docs/site/Doxyfile | xargs touch
# fails_with WORDS COMMAND...: the command fails, and says so.
fails_with() {
  local output
  if output=$("${@:2}" 2>&1) || ! grep -qF -- "$1" <<<"$output"; then
    echo "${*:2} does not end with \"$1\": $output"
    failed=1
  fi
}
printf '// A header.\n#pragma once\nnamespace zstrip {\n/// A square.\nstruct Square {\n  int side;\n};\n}\n' >core/zstrip/square.hpp
fails_with "Member side (variable) of struct zstrip::Square is not documented" docs/site/build_api api
sed -i 's|int side;|int side;  ///< pixels|' core/zstrip/square.hpp
docs/site/build_api api || { echo "complains about a good header"; failed=1; }
printf '# A page\n[another](missing.md)\n' >README.md
fails_with "'missing.md' which is not found" docs/site/build site

# Lists and tables as Python's Markdown wants them; code stays as it is.
printf '%s\n' 'Text' '- item' '  - nested' '| `a\|b` | c \| d |' '```' 'text' '- `a\|b`' '```' >README.md
docs/site/gather_pages.py . pages
diff pages/README.md - <<'EOF' || { echo "gathers another page"; failed=1; }
Text

- item
    - nested
| `a|b` | c \| d |
```
text
- `a\|b`
```
EOF
exit "$failed"
