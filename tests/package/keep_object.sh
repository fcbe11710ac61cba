#!/bin/sh
# keep_object.sh FOLDER COMMAND... SOURCE -o OUTPUT: what arduino-builder runs for each source, to see what it includes
# (-E) and to compile it. What a library's source gave for the first sketch is kept in FOLDER for the others.
set -eu
kept=$1
shift
kind=o source='' before='' output=''
for word; do
  if [ "$word" = -E ]; then kind=seen; fi
  source=$before before=$output output=$word
done
case $source in
  */libraries/*) kept=$kept/${source#*/libraries/}.$kind ;;
  *) exec "$@" ;;
esac
if [ ! -e "$kept" ]; then
  "$@"
  mkdir -p "${kept%/*}"
  if [ -f "$output" ]; then cp "$output" "$kept"; else : >"$kept"; fi
elif [ "$output" != /dev/null ]; then
  cp "$kept" "$output"
fi
