# Sourced by host-sim/run and tests/run: installs missing Debian packages, configures and builds.
# The caller runs under `set -euo pipefail` and gets 3 when the machine lacks something, 1 when a build fails.

zstrip_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
zstrip_build=$zstrip_root/build/host
zstrip_log=$zstrip_root/build/build.log
zstrip_lock=$zstrip_root/build/.lock  # of zstrip_with_lock; in it stands what is being done

zstrip_say() { printf 'zstrip: %s\n' "$*" >&2; }

# The packages for the given purposes, one a line.
zstrip_packages() {
  awk -v wanted=" $* " '!/^#/ && NF == 2 && index(wanted, " " $1 " ") { print $2 }' "$zstrip_root/cmake/zstrip_packages.txt"
}

# Prints the packages of standard input that are not installed; all of them if dpkg-query does not answer.
# A name that another package provides counts.
zstrip_missing_packages() {
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' 2>/dev/null |
    awk '$1 == "installed" { sub(/^installed /, ""); gsub(/ *\([^)]*\)/, ""); gsub(/, */, "\n"); print }') || installed=
  grep -vxF -f <(printf '%s\n' "$installed") || [ $? -eq 1 ]
}

# On machines without Debian's packages: whether what the purposes need is there. Configuring finds it.
zstrip_can_configure() {
  local tool purpose tests=OFF firmware=OFF probe=$zstrip_root/build/probe found=yes
  local tools=(cmake ninja)
  for purpose in "$@"; do
    case "$purpose" in
      tests) tests=ON ;;
      firmware) firmware=ON; tools+=(qemu-system-arm) ;;
    esac
  done
  : >"$zstrip_log"
  for tool in "${tools[@]}"; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed" >>"$zstrip_log"; found=; }
  done
  if [ -n "$found" ]; then
    rm -rf "$probe"
    cmake -S "$zstrip_root" --preset host -B "$probe" -DZSTRIP_TESTS=$tests -DZSTRIP_FIRMWARE=$firmware \
      </dev/null >>"$zstrip_log" 2>&1 9>&- || found=
    rm -rf "$probe"
  fi
  [ -n "$found" ]
}

zstrip_apt() {
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@" </dev/null >>"$zstrip_log" 2>&1
}

# Installs what is missing for the given purposes, or exits with 3. Looks only once after each change of the list.
zstrip_install_packages() {
  local stamp names missing
  stamp=$zstrip_root/build/.packages-$(printf '%s-' "$@")installed
  if [ "$stamp" -nt "$zstrip_root/cmake/zstrip_packages.txt" ]; then return; fi
  names=$(zstrip_packages "$@" | zstrip_missing_packages)
  read -r -d '' -a missing <<<"$names" || true
  if [ -n "$names" ] && ! command -v apt-get >/dev/null; then
    if ! zstrip_can_configure "$@"; then
      tail -n 20 "$zstrip_log" >&2
      zstrip_say "there is no apt-get here; install what these Debian packages hold, then try again:"
      printf '  %s\n' "${missing[@]}" >&2
      exit 3
    fi
  elif [ -n "$names" ]; then
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
      zstrip_say "packages are missing and neither root nor sudo is at hand; as root, run:"
      printf '  apt-get install --no-install-recommends %s\n' "${missing[*]}" >&2
      exit 3
    fi
    zstrip_say "installing ${missing[*]}"
    echo "process $$ is installing packages" >"$zstrip_lock"
    : >"$zstrip_log"
    # An index that is empty or too old is the usual reason for a failure: fetch it then, and only then.
    if ! apt-cache show "${missing[@]}" >/dev/null 2>&1 ||
       ! zstrip_apt install --yes --no-install-recommends "${missing[@]}"; then
      if ! { zstrip_apt update && zstrip_apt install --yes --no-install-recommends "${missing[@]}"; }; then
        tail -n 20 "$zstrip_log" >&2
        zstrip_say "could not install the packages; the whole log is $zstrip_log"
        exit 3
      fi
    fi
  fi
  touch "$stamp"
}

# Shows what is being done, until it is ended. After a second, so that a build with nothing to do prints nothing; then
# ninja's last [n/m]: on a terminal on one line, else every 30 seconds, in CI every 5 minutes.
zstrip_progress() {
  local what=$1 seconds=0 every=30 step last= on_line=
  if [ -n "${CI-}" ]; then every=300; fi
  trap 'if [ -n "$on_line" ]; then echo >&2; fi; exit 0' TERM
  while true; do
    sleep 1 </dev/null >/dev/null 2>&1 &
    wait $!
    # Background jobs ignore an interrupt that ends the caller.
    kill -0 $$ 2>/dev/null || exit 0
    seconds=$((seconds + 1))
    step=$(tail -c 20000 "$zstrip_log" | sed -n 's|^\(\[[0-9]*/[0-9]*\]\).*|\1 |p' | tail -n 1) || step=
    if [ -t 2 ]; then
      printf '\r\033[K%.79s' "zstrip: $step$what" >&2
      on_line=yes
    elif [ "$seconds" -eq 1 ]; then
      zstrip_say "$what"
    elif [ $((seconds % every)) -eq 0 ] && [ "$step" != "$last" ]; then
      zstrip_say "$step$what"
      last=$step
    fi
  done
}

# Runs a command with its output in the log, which is shown if the command fails. Its 3 is passed on.
zstrip_quietly() {
  local what=$1 progress status=0
  shift
  : >"$zstrip_log"
  echo "process $$ is $what" >"$zstrip_lock"
  zstrip_progress "$what" 9>&- &
  progress=$!
  "$@" </dev/null >>"$zstrip_log" 2>&1 9>&- || status=$?
  kill "$progress" 2>/dev/null || true
  wait "$progress" 2>/dev/null || true
  if [ "$status" -ne 0 ]; then
    tail -n 60 "$zstrip_log" >&2
    zstrip_say "failed: $what; the whole log is $zstrip_log"
    exit $((status == 3 ? 3 : 1))
  fi
}

# zstrip_with_lock FUNCTION ARGS...: one build at a time; later ones say what they wait for, each minute, and then find
# everything built.
zstrip_with_lock() {
  local seconds=0
  mkdir -p "$zstrip_root/build" || { zstrip_say "cannot write to $zstrip_root/build"; exit 3; }
  exec 9>>"$zstrip_lock"
  if command -v flock >/dev/null; then
    # Status 1: another one has it.
    until flock --timeout "$seconds" 9 || [ $? -ne 1 ]; do
      zstrip_say "another zstrip build runs ($(cat "$zstrip_lock")); waiting"
      seconds=60
    done
  fi
  "$@"
  exec 9>&-
}
