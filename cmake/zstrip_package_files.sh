# Sourced by the scripts that make packages: the version, and the same bytes anywhere. The caller runs under
# `set -euo pipefail`.

zstrip_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
zstrip_version=$(sed -nE 's/^project\(zstrip VERSION ([0-9.]+) .*/\1/p' "$zstrip_root/CMakeLists.txt")
[ -n "$zstrip_version" ] || { echo "CMakeLists.txt states no version" >&2; exit 1; }
# The day of its section: builds of users look at times of files, and those of a later release are later.
zstrip_day=$(sed -nE "s/^## \\[${zstrip_version//./\\.}\\] - ([0-9]{4}-[0-9]{2}-[0-9]{2})\$/\\1/p" "$zstrip_root/CHANGELOG.md")
[ -n "$zstrip_day" ] || { echo "CHANGELOG.md has no section of version $zstrip_version with its day" >&2; exit 1; }
export LC_ALL=C TZ=UTC

# zstrip_write_out FOLDER URL: version and address in place of @VERSION@ and @URL@; without an address lines that have one
# are left out. Then nothing of this machine and this hour: times, modes.
zstrip_write_out() {
  local file
  while IFS= read -r file; do
    sed -i -e "s|@VERSION@|$zstrip_version|" -e "${2:+s|@URL@|$2|;}/@URL@/d" "$file"
  done < <(grep -rlE '@(VERSION|URL)@' "$1")
  find "$1" -exec touch -h -d "$zstrip_day 00:00:00 UTC" {} +
  chmod -R u=rwX,go=rX "$1"
}

# zstrip_archive FOLDER: as .tar.gz on standard output, without owners and in order.
zstrip_archive() {
  tar --sort=name --owner=0 --group=0 --numeric-owner --format=ustar -cf - "$1" | gzip -9n
}

# zstrip_player_package NAME FOLDER [URL]: writes zstrip-NAME and its archive into FOLDER: firmware/NAME, and in its folder
# cpp the sources of the player.
zstrip_player_package() {
  local package=zstrip-$1 library
  mkdir -p "$2"
  cd "$2"
  library=$(mktemp -d)
  trap "rm -rf '$library'" EXIT
  bash "$zstrip_root/cmake/zstrip_package_sources.sh" "$library"
  rm -rf "$package"
  cp -R "$zstrip_root/firmware/$1" "$package"
  mkdir "$package/cpp"
  cp -R "$library"/zstrip/src/{zstrip,zstrip_hal,zstrip_player,zstrip_player.h,zstrip_scenes} "$package/cpp"
  cp "$zstrip_root"/{LICENSE,CHANGELOG.md} "$package"
  zstrip_write_out "$package" "${3-}"
  zstrip_archive "$package" >"$package-$zstrip_version.tar.gz"
}
