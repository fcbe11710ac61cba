#!/usr/bin/env bash
# newcomer_of_build.sh ROOT BUILD: newcomer.sh with the packages of this build, without the parts of a release that take
# minutes.
set -euo pipefail
root=$(cd "$1" && pwd -P)
for tool in cpack dpkg-shlibdeps dpkg-deb zip pkg-config g++ cmake; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/release"
bash "$root/cmake/zstrip_package_sources.sh" "$scratch/packages"
cpack --config "$2/CPackConfig.cmake" -G DEB -B "$scratch/packages" >"$scratch/said" 2>&1 || { cat "$scratch/said"; exit 1; }
mv "$scratch"/packages/*.{tar.gz,zip,deb} "$scratch/release"
(cd "$scratch/release" && sha256sum -- * >"$scratch/sums" && mv "$scratch/sums" SHA256SUMS)
bash "$root/tests/package/newcomer.sh" "$scratch/release"
