#!/usr/bin/env bash
# readme_commands.sh ROOT ZSTRIP: every command in a ```sh block of the README, and of those that host-sim/run proposes,
# exists: script, preset, subcommand and options. Those that list scenes or render one that is built in are run.
set -euo pipefail
cd "$1"
zstrip=$2
failed=0
seen=0
ran=0
pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT

complain() {
  echo "$page: $1"
  failed=1
}

# A zstrip command line: the subcommand must exist, and its help must name every option used.
check_zstrip() {
  local line=$1 subcommand=${2-} help option output model=
  case "$subcommand" in '' | -*) return ;; esac
  if ! help=$("$zstrip" "$subcommand" --help </dev/null 2>&1); then complain "no such command: $line"; return; fi
  for option in "${@:3}"; do
    case "$option" in
      *.obj | *.glb | *.gltf) model=$option ;;
      -*) grep -qE -- "(^|[ ,])${option%%=*}([ ,=]|$)" <<<"$help" || complain "zstrip $subcommand has no option ${option%%=*}: $line" ;;
    esac
  done
  if [ -z "$model" ] && [[ $subcommand = render || $subcommand = scenes ]]; then
    ran=$((ran + 1))
    output=$(cd "$pictures" && "$zstrip" "${@:2}" </dev/null 2>&1) || complain "ended with $?: $line: $output"
  fi
}

# Command lines of a page on standard input.
check_lines() {
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
  done
}

page=README.md
check_lines < <(awk '/^```/ { inside = ($0 ~ /^```(sh|bash|console)$/) ; next } inside { sub(/^\$ /, ""); print }' README.md)
[ "$seen" -gt 0 ] || complain "holds no \`\`\`sh block with a command"

# "  $0 COMMAND   what it does"
page=host-sim/run
check_lines < <(sed -nE 's/^  \$0 (.*[^ ])   .*/.\/host-sim\/run \1/p' host-sim/run)
[ "$ran" -gt 1 ] || complain "proposes no command that can be tried"
exit "$failed"
