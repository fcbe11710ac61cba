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
