#!/usr/bin/env bash
# names.sh ROOT: functions and files that the documents for developers list exist.
set -euo pipefail
command -v python3 >/dev/null || { echo "python3 is not installed"; exit 77; }
"$1/tests/docs/check_names.py" "$1"
