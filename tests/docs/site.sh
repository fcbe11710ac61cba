#!/usr/bin/env bash
# site.sh ROOT FOLDER: the site builds, without a warning of mkdocs or doxygen. Its first pages lead where a reader goes
# next; where the playground is part of it, the gallery opens scenes there.
set -euo pipefail
for tool in mkdocs doxygen; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
[[ $(mkdocs build --help) = *material* ]] || { echo "mkdocs-material is not installed"; exit 77; }
rm -rf "$2"
"$1/docs/site/build" "$2"
[ -s "$2/html/index.html" ] && [ -s "$2/html/api/index.html" ] || { echo "the site lacks its first pages"; exit 1; }
# The same bytes wherever it is built.
named=$(grep -rlF "$(cd "$1" && pwd -P)" "$2/html" | head -n 3) || true
[ -z "$named" ] || { printf 'pages name the folder of the sources:\n%s\n' "$named"; exit 1; }
leads() { grep -q "href=\"[./]*$2\"" "$site/$1" || { echo "$1 does not lead to $2"; exit 1; }; }
site=$2/html
for page in docs/playground.html docs/porting.html docs/gallery.html; do leads index.html $page; done
for page in index.html player_8hpp.html scene_8hpp.html display_8hpp.html; do leads api/index.html $page; done

mkdir "$2/playground"
touch "$2/playground/index.html"
python3 "$1/docs/site/gather_pages.py" "$1" "$2/with_playground" "$2/playground"
grep -q '(../play/index.html#scene=gallery/lighthouse.toml)' "$2/with_playground/docs/gallery.md" ||
  { echo "the gallery opens no scene in the playground"; exit 1; }
