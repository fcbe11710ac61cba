#!/bin/sh
# keep_object.sh FOLDER COMMAND... SOURCE -o OUTPUT: what arduino-builder runs for each source, to see what it includes
# (-E) and to compile it. What a library's source gave for the first sketch is kept in FOLDER for the others. If FOLDER
# has core.cpp, that is compiled in place of the core's first source, and none.cpp in place of its others.
set -eu
folder=$1 kept=$1
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
  if [ -e "$folder/core.cpp" ] && [ $kind = o ]; then
    case $source in
      */src/zstrip/*.cpp)
        if mkdir "$folder/joined" 2>/dev/null; then other=$folder/core.cpp; else other=$folder/none.cpp; fi
        for word; do
          shift
          if [ "$word" = "$source" ]; then word=$other; fi
          set -- "$@" "$word"
        done ;;
    esac
  fi
  "$@"
  mkdir -p "${kept%/*}"
  if [ -f "$output" ]; then cp "$output" "$kept"; else : >"$kept"; fi
elif [ "$output" != /dev/null ]; then
  cp "$kept" "$output"
fi
