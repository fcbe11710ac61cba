# Sourced by checks that compile sources one by one or look at them: how a build compiles each.

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
