#!/usr/bin/env bash
# sanitized.sh PARTS PROGRAM ARGS...: runs a GoogleTest program; of its tests one part of so many, which changes every second
# day (on the days between, tests/run has other programs), or all with ZSTRIP_LONG.
set -euo pipefail
parts=$1
shift
if [ -z "${ZSTRIP_LONG-}" ]; then
  export GTEST_TOTAL_SHARDS=$parts GTEST_SHARD_INDEX=$(($(date +%s) / 86400 / 2 % parts))
fi
exec "$@"
