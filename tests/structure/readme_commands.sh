#!/usr/bin/env bash
# readme_commands.sh ROOT ZSTRIP: every command in a ```sh block of the README exists: script, preset, subcommand and options.
set -euo pipefail
cd "$1"
zstrip=$2
failed=0
seen=0

complain() {
  echo "README.md: $1"
  failed=1
}

# A zstrip command line: the subcommand must exist, and its help must name every option used.
check_zstrip() {
  local line=$1 subcommand=${2-} help option
  case "$subcommand" in '' | -*) return ;; esac
  if ! help=$("$zstrip" "$subcommand" --help </dev/null 2>&1); then complain "no such command: $line"; return; fi
  for option in "${@:3}"; do
    case "$option" in
      -*) grep -qE -- "(^|[ ,])${option%%=*}([ ,=]|$)" <<<"$help" || complain "zstrip $subcommand has no option ${option%%=*}: $line" ;;
    esac
  done
}

while IFS= read -r line; do
  line=${line%%#*}
  read -ra words <<<"$line"
  [ "${#words[@]}" -gt 0 ] || continue
  seen=$((seen + 1))
  case "${words[0]}" in
    ./host-sim/run) [ -x host-sim/run ] || complain "not executable: $line"; check_zstrip "$line" "${words[@]:1:1}" "${words[@]:2}" ;;
    zstrip) check_zstrip "$line" "${words[@]:1:1}" "${words[@]:2}" ;;
    ./*) [ -x "${words[0]}" ] || complain "not an executable of the repository: $line" ;;
  esac
  for i in "${!words[@]}"; do
    if [ "${words[i]}" = --preset ]; then
      grep -q "\"name\": \"${words[i + 1]}\"" CMakePresets.json || complain "no such preset: $line"
    fi
  done
done < <(awk '/^```/ { inside = ($0 ~ /^```(sh|bash|console)$/) ; next } inside { sub(/^\$ /, ""); print }' README.md)

[ "$seen" -gt 0 ] || complain "holds no \`\`\`sh block with a command"
exit "$failed"
