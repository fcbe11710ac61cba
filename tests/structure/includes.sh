#!/usr/bin/env bash
# includes.sh ROOT: core and hal know nothing of each other or of programs, and no stage of core includes a later one.
# Only hal/linux includes headers of an operating system.
set -euo pipefail
cd "$1"

# In the order in which data flows; a stage may include itself and what stands before it.
stages=(base scene store plan geometry visibility raster resolve frame)
failed=0

# Every quoted or angled include of the C++ files in a folder, as "file:line:path".
includes_of() {
  grep -rnE --include='*.hpp' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' "$1" |
    sed -E 's/^([^:]+:[0-9]+):[^<"]*[<"]([^>"]+)[>"].*/\1:\2/'
}

complain() {
  echo "$1"
  failed=1
}

while IFS=: read -r file line path; do
  from=$(cut -d/ -f3 <<<"$file")
  # The compiler's own header for its vectors, in one place.
  if [ "$file $path" = "core/zstrip/base/sse2_intrinsics.hpp emmintrin.h" ]; then continue; fi
  case "$path" in
    zstrip/*) to=$(cut -d/ -f2 <<<"$path") ;;
    */* | *.hpp | *.h) complain "$file:$line: core includes $path: only zstrip/... and the C++ library are allowed"; continue ;;
    *) continue ;;
  esac
  # The one header that gives everything to applications; no stage is called so, so that none can include it.
  if [ "$file" = core/zstrip/zstrip.hpp ]; then from=${stages[-1]}; fi
  from_at=-1 to_at=-1
  for i in "${!stages[@]}"; do
    if [ "${stages[i]}" = "$from" ]; then from_at=$i; fi
    if [ "${stages[i]}" = "$to" ]; then to_at=$i; fi
  done
  if [ "$from_at" -lt 0 ]; then complain "$file: the stage $from is not one of: ${stages[*]}"; fi
  if [ "$to_at" -lt 0 ]; then complain "$file:$line: the stage of $path is not one of: ${stages[*]}"; fi
  if [ "$to_at" -gt "$from_at" ]; then complain "$file:$line: $from includes $path of the later stage $to"; fi
  if [ ! -e "core/$path" ]; then complain "$file:$line: $path does not exist"; fi
done < <(includes_of core)

while IFS=: read -r file line path; do
  case "$file $path" in
    hal/linux/*" zstrip_hal_linux/"*) if [ ! -e "hal/linux/$path" ]; then complain "$file:$line: $path does not exist"; fi ;;
    *" zstrip_hal/"*) if [ ! -e "hal/$path" ]; then complain "$file:$line: $path does not exist"; fi ;;
    *" zstrip"*/*) complain "$file:$line: hal includes $path: only zstrip_hal/... is allowed" ;;
    hal/linux/*) ;;
    *" "*/* | *.hpp | *.h) complain "$file:$line: hal includes $path: only zstrip_hal/... and the C++ library are allowed" ;;
  esac
done < <(includes_of hal)

exit "$failed"
