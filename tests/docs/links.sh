#!/usr/bin/env bash
# links.sh FOLDER: every link of the site that Docs.Site has built leads somewhere.
set -euo pipefail
[ -e "$1/html" ] || { echo "there is no site: what builds it is not installed"; exit 77; }
"$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/check_links.py" "$1/html"
