#!/usr/bin/env bash
# layout.sh ROOT: the top level holds nothing unexpected, and no file names a path of one machine.
set -euo pipefail
cd "$1"
failed=0

# build*/ and out/ are what builds and first pictures leave behind; git ignores them.
unexpected=$(find . -mindepth 1 -maxdepth 1 -printf '%P\n' | grep -vxE \
  '\..*|CMakeLists\.txt|CMakePresets\.json|README\.md|LICENSE|CHANGELOG\.md|core|hal|firmware|host-sim|tests|docs|cmake|build.*|out' || true)
if [ -n "$unexpected" ]; then
  echo "unexpected at the top level:" $unexpected
  failed=1
fi

# A folder of somebody's machine: only at the start of a path, for a folder in the repository may have the same name.
machine_path='(^|[^A-Za-z0-9_.})>])/(work|root|home/[a-z][a-z0-9_-]*|tmp/[a-z]+-[a-z]+)/'
found=$(grep -rnIE --exclude-dir=.git --exclude=.git --exclude-dir=.cache --exclude-dir='build*' --exclude-dir=out "$machine_path" . || true)
if [ -n "$found" ]; then
  printf 'paths of one machine:\n%s\n' "$found"
  failed=1
fi

exit "$failed"
