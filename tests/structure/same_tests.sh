#!/usr/bin/env bash
# same_tests.sh ROOT: a commit has the same tests everywhere and at all times: nothing that builds, chooses or runs tests
# asks for the date, the name of the machine, chance, or what git knows. A release asks git for its commit; its day is the
# changelog's.
set -euo pipefail
cd "$1"
asks='\bdate ["'\''+-]|string\(TIMESTAMP|EPOCH(SECONDS|REALTIME)|[^_]HOSTNAME|\bhostname\b|uname -n|\$RANDOM|\bshuf\b|random_device'
asks+='|\b(localtime|gmtime|strftime)|std::time\(|system_clock|new Date|\bgit (-C \S+ )?(diff|log|merge-base|rev-|show|status)'
found=$(grep -rnIE --exclude="$(basename "$0")" --exclude=zstrip_release.sh --exclude='*.md' "$asks" tests cmake CMakeLists.txt CMakePresets.json || true)
if [ -n "$found" ]; then
  printf 'what tests there are depends on more than the commit:\n%s\n' "$found"
  exit 1
fi
