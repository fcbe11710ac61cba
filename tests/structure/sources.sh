# Sourced by checks that compile sources one by one or look at them: how a build compiles each, and which are looked at.

# source_commands BUILD FOLDER...: for each .cpp file of these folders that the build compiles: the command up to the
# folder of its program's objects, a tab, the file, a tab, the joined source (Unity) that it is compiled in or nothing.
source_commands() {
  local build=$1 folders
  shift
  folders=$(IFS='|'; echo "$*")
  sed -nE 's/^ *"command": "(.*) -c .*",?$/\1/; T file; s/( -o [^ ]*\.dir)\/[^ ]*$/\1/; p; :file; s/^ *"file": "(.*)",?$/\t\1/p' \
      "$build/compile_commands.json" | paste -d '' - - | sed 's/\\"/"/g; s/\\\\/\\/g' |
    awk -F '\t' -v OFS='\t' '
      $2 !~ /\/Unity\/[^/]*$/ { print $1, $2, ""; next }
      { while ((getline line < $2) > 0) if (match(line, /"[^"]*"/)) print $1, substr(line, RSTART + 1, RLENGTH - 2), $2
        close($2) }' |
    grep -E "	($folders)/[^	]*\.cpp	" | awk -F '\t' '!seen[$2]++'
}

# changed_files ROOT: what differs from the main branch; on the main branch itself what its last day has changed.
changed_files() {
  local root=$1 head base
  if ! head=$(git -C "$root" rev-parse -q --verify HEAD 2>/dev/null); then return 0; fi
  base=$(git -C "$root" merge-base HEAD origin/main 2>/dev/null || git -C "$root" merge-base HEAD main 2>/dev/null) || base=$head
  if [ "$base" = "$head" ]; then
    base=$(git -C "$root" rev-list -1 --before="$(($(git -C "$root" show -s --format=%ct HEAD) - 86400))" HEAD)
  fi
  git -C "$root" diff --name-only --diff-filter=d "${base:-HEAD}"
  git -C "$root" ls-files --others --exclude-standard
}

# chosen ROOT MOST: of lines of source_commands those to look at: all with ZSTRIP_LONG; else at most MOST that have
# changed, a header counting as the source beside it, and one of 16 that the date chooses.
chosen() {
  local root=$1 most=$2 changed
  if [ -n "${ZSTRIP_LONG-}" ]; then cat; return; fi
  changed=$(changed_files "$root" | sed -nE 's/\.hpp$/.cpp/; /\.cpp$/p' | sort -u | sed -n "1,${most}p")
  awk -F '\t' -v root="$root/" -v changed="$changed" -v today="$(($(date +%s) / 86400 % 16))" '
    BEGIN { count = split(changed, list, "\n"); for (i = 1; i <= count; ++i) has_changed[root list[i]] = 1 }
    NR % 16 == today || $2 in has_changed'
}
