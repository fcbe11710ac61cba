# Sourced by checks that search the tree, under `set -euo pipefail`.

# lines GREP_ARGUMENTS...: sets `found` to what grep prints, empty if nothing matches. Ends the script where grep fails: a
# place that is missing would hold no mistake.
lines() {
  local status=0
  found=$(grep "$@") || status=$?
  if [ "$status" -gt 1 ]; then
    echo "grep cannot search, status $status: grep $*"
    exit 1
  fi
}
