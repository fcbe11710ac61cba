#!/usr/bin/env bash
# site.sh ROOT FOLDER: the site builds, without a warning of mkdocs or doxygen.
set -euo pipefail
for tool in mkdocs doxygen; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
rm -rf "$2"
"$1/docs/site/build" "$2"
[ -s "$2/html/index.html" ] && [ -s "$2/html/api/index.html" ] || { echo "the site lacks its first pages"; exit 1; }
