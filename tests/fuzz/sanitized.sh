#!/usr/bin/env bash
# sanitized.sh PARTS PROGRAM ARGS...: runs a GoogleTest program; of its tests one part of so many, which the date chooses, or
# all with ZSTRIP_LONG.
set -euo pipefail
parts=$1
shift
if [ -z "${ZSTRIP_LONG-}" ]; then
  export GTEST_TOTAL_SHARDS=$parts GTEST_SHARD_INDEX=$(($(date +%s) / 86400 % parts))
fi
exec "$@"
