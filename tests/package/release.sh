#!/usr/bin/env bash
# release.sh ROOT FOLDER [PART...]: cmake/zstrip_release.sh makes these parts of a release twice, all by default: the second
# time from a copy elsewhere, in another time zone and with other rights. Both have the same bytes, and the script's
# newcomer (newcomer.sh) is content with them. The release is of the files of ROOT as they are, committed or not.
set -euo pipefail
root=$(cd "$1" && pwd -P)
tools=(git zip)
if [ $# -eq 2 ]; then tools+=(arm-none-eabi-g++ riscv64-unknown-elf-g++ clang lld emcmake mkdocs doxygen dpkg-shlibdeps); fi
for tool in "${tools[@]}"; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
rm -rf "$2"
mkdir -p "$2/first_root"
folder=$(cd "$2" && pwd -P)
cd "$folder"

git -C "$root" ls-files -z --cached --others --exclude-standard >files 2>said || { cat said; exit 77; }
# Files that are deleted, but not yet in a commit, are left out.
{ tar -C "$root" --null --ignore-failed-read --verbatim-files-from -T files -cf - 2>said || true; } | tar -C first_root -xf -
export GIT_AUTHOR_DATE='2000-01-01T00:00:00Z' GIT_COMMITTER_DATE='2000-01-01T00:00:00Z' GIT_CONFIG_GLOBAL=/dev/null
git -C first_root init -q
git -C first_root add -A
git -C first_root -c user.name=zstrip -c user.email=zstrip@example.org commit -q -m "a release"
(umask 077 && git clone -q first_root second_root)

bash first_root/cmake/zstrip_release.sh first --url https://example.org/zstrip "${@:3}" >said 2>&1 || { cat said; exit 1; }
(umask 077 && TZ=Asia/Tokyo bash second_root/cmake/zstrip_release.sh second --url https://example.org/zstrip "${@:3}") \
  >said 2>&1 || { cat said; exit 1; }
diff first/SHA256SUMS second/SHA256SUMS || { echo "the second release has other bytes"; exit 1; }
cat first/SHA256SUMS
