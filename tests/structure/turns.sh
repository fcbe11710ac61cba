#!/usr/bin/env bash
# turns.sh ROOT BUILD: what takes turns by the date has its day, one of as many as are said, and keeps it at midnight;
# and no target keeps the core that a run of everything has left in its folder.
set -euo pipefail
root=$1
build=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/turns.cmake" <<'END'
cmake_minimum_required(VERSION 3.22)
set(ZSTRIP_TARGETS_IN_TURN ON)
include(${ROOT}/cmake/zstrip_turns.cmake)
foreach(time IN ITEMS before after)
  foreach(number RANGE 1 ${DAYS})
    zstrip_is_today(today ${number} ${DAYS})
    if(today)
      list(APPEND ${time} ${number})
    endif()
  endforeach()
  set(ENV{SOURCE_DATE_EPOCH} ${NEXT_DAY})
endforeach()
if(NOT before STREQUAL after)
  message("after midnight it is the turn of ${after}, no longer of ${before}")
else()
  message("${before}")
endif()
END

failed=0
for days in 2 4 5; do
  expected='' found=''
  for ((day = 20000; day < 20000 + days; ++day)); do
    expected+="$((day % days == 0 ? days : day % days)) "
    found+="$(SOURCE_DATE_EPOCH=$((day * 86400 + 86399)) cmake -DROOT="$root" -DDAYS=$days \
      -DNEXT_DAY=$(((day + 1) * 86400)) -P "$scratch/turns.cmake" 2>&1) "
  done
  if [ "$found" != "$expected" ]; then
    echo "of $days, day by day: $found; not $expected"
    failed=1
  fi
done

if [ $failed = 1 ]; then exit 1; fi

targets=$(grep '^add_test' "$build/tests/targets/CTestTestfile.cmake" | grep -e -DFRAME_SET_BOARD= |
  grep -vE -e '-DFRAME_SET_BOARD=(host|linux)"') || true
if [ -z "$targets" ]; then
  echo "no target for a board is tested here"
  exit 77
fi
if kept=$(grep -v -e -DFRAME_SET_CORE_LIBRARY= <<<"$targets"); then
  echo "these do not say whose core they take: $(grep -o 'Targets\.[a-z0-9_]*' <<<"$kept" | paste -sd ' ')"
  exit 1
fi
