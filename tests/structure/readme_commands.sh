#!/usr/bin/env bash
# readme_commands.sh ROOT ZSTRIP: every command in a ```sh block of the README, of docs/try.md, docs/program.md,
# docs/troubleshooting.md, whose files are taken out of the page, and "Plain CMake" in docs/contributing.md, and each
# that host-sim/run proposes, is run, in a copy of the sources. So that
# nothing is compiled a second time, ZSTRIP stands for the command that they build, and cmake only plans its builds: of
# what it plans, EachFile and Consumer compile the rest. Left to other tests: installing (Consumer), a program with
# pkg-config (Package.Debian), the board's program in the emulator (BakeBoard), and tests/run, which has run this.
set -euo pipefail
root=$(cd "$1" && pwd -P)
zstrip=$(readlink -f "$2")
failed=0
ran=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mkdir -p "$scratch"/{bin,home,tree}
tar -C "$root" --exclude=./.git --exclude='./build*' --exclude=./out -cf - . | tar -C "$scratch/tree" -xf -
cd "$scratch/tree"
mkdir -p build/host/host-sim
ln -s "$zstrip" build/host/host-sim/zstrip
cp tests/bake/models/house.obj model.obj
glb=/usr/share/assimp/models/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb
if [ -e "$glb" ]; then cp "$glb" model.glb; fi

# puts PROGRAM BODY: one that is found before the machine's.
puts() {
  printf '#!/usr/bin/env bash\n%s\n' "$2" >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}
puts cmake "case \" \$* \" in
  *' --build '*/firmware/cortex-*) exit 0 ;;
  *' --build '*) exec $(command -v cmake) \"\$@\" -- -n ;;
  *' --install '* | *' your_project '*) exit 0 ;;
esac
exec $(command -v cmake) \"\$@\""
puts g++ "case \" \$* \" in *' main.cpp '*) exit 0 ;; esac
exec $(command -v g++) \"\$@\""
puts ctest "exec $(command -v ctest) \"\$@\" -N"
puts qemu-system-arm "case \"\$*\" in *'-kernel build/m3/'*) exit 0 ;; esac
exec $(command -v qemu-system-arm) \"\$@\""
puts zstrip "exec '$scratch/tree/host-sim/run' \"\$@\""
export PATH=$scratch/bin:$PATH HOME=$scratch/home SDL_VIDEODRIVER=dummy

# Command lines of a page on standard input.
run_lines() {
  local line output
  while IFS= read -r line; do
    line=${line%%#*}
    if [ -z "${line// /}" ] || [[ $line = ./tests/run* ]]; then continue; fi
    if [ ! -e model.glb ]; then line=${line//model.glb/model.obj}; fi
    # A window that is closed at once.
    if [[ $line = *run\ view\ * ]]; then line+=" --press q"; fi
    ran=$((ran + 1))
    if ! output=$(bash -c "$line" </dev/null 2>&1); then
      echo "$page: $line: $(tail -n 20 <<<"$output")"
      failed=1
    fi
  done
}

# run_page LEAST PAGE [SECTION]: all commands of a page, or of a section of it; at least so many.
run_page() {
  local before=$ran
  page=$2
  run_lines < <(awk -v section="${3-}" '
    /^## / { here = $0 == "## " section }
    /^```/ { inside = ($0 ~ /^```(sh|bash|console)$/); next }
    inside && (section == "" || here) { sub(/^\$ /, ""); print }' "$2")
  [ $((ran - before)) -ge "$1" ] || { echo "$page ${3-} holds fewer commands than $1"; failed=1; }
}
run_page 1 README.md
run_page 10 docs/try.md
run_page 4 docs/program.md
# A block after a line <!-- NAME --> is that file.
awk '/^<!-- [a-z_]+\.(obj|toml) -->$/ { file = $2; next }
  /^```/ { inside = file != "" && !inside; if (!inside) file = ""; next }
  inside { print >file }' docs/troubleshooting.md
run_page 14 docs/troubleshooting.md
run_page 2 docs/contributing.md "Plain CMake"
# "  $0 COMMAND   what it does"
page=host-sim/run
proposed=$ran
run_lines < <(sed -nE 's/^  \$0 (.*[^ ])   .*/.\/host-sim\/run \1/p' host-sim/run)
[ "$ran" -gt $((proposed + 1)) ] || { echo "host-sim/run proposes no commands"; failed=1; }
echo "$ran commands run"
exit "$failed"
