#!/usr/bin/env bash
# guest_progress.sh FOLDER: what guest.sh says of downloads that stop, and of a package that cannot be had, with programs
# in place of Debian's. It ends then, and a download that is only slow is waited for, and so is one that a build has begun.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
folder=$1
failed=0
export PATH=$folder/bin:$PATH ZSTRIP_GUEST_PATIENCE=3

# apt BODY: a machine whose apt-get does this, with the words of its command line after the options in $*.
apt() {
  rm -rf "$folder"
  mkdir -p "$folder"/{bin,guest}
  for tool in dpkg-deb cpio dtc qemu-system-arm qemu-system-aarch64 qemu-system-x86_64 arm-linux-gnueabihf-g++ \
    aarch64-linux-gnu-g++ ninja; do
    ln -s /bin/true "$folder/bin/$tool"
  done
  printf '%s\n' '#!/bin/sh' 'case "$*" in indextargets*) echo "http://mirror/debian bookworm main" ;; esac' "$1" >"$folder/bin/apt-get"
  printf '%s\n' '#!/bin/sh' 'echo "Version: 6.1.1"; echo "Depends: linux-image-6.1"' >"$folder/bin/apt-cache"
  chmod +x "$folder"/bin/apt-{get,cache}
}
# ends_with SAID...: guest.sh skips the machines, and says each of these.
ends_with() {
  local output said status=0
  output=$(timeout 60 bash "$here/guest.sh" "$folder" "$folder/guest" /bin/true 2>&1) || status=$?
  [ "$status" -eq 77 ] || { echo "guest.sh ended with $status: $output"; failed=1; }
  for said in "$@"; do grep -qF -- "$said" <<<"$output" || { echo "guest.sh does not say '$said': $output"; failed=1; }; done
  grep -qF -- "${!#}" "$folder/guest/missing" || { echo "not among what is missing: ${!#}"; failed=1; }
}

apt 'case "$*" in *" update") exec sleep 1000 ;; esac'
ends_with "downloading the index of Debian bookworm" "index for Arm cannot be downloaded: nothing new for 3 s"
# A byte a second is progress.
apt 'case "$*" in *" update") for i in 1 2 3 4 5; do sleep 1; echo "$i"; done ;; *" download busybox"*) echo "it is gone"; exit 100 ;;
  *" download "*) touch package.deb; echo byte >package.deb ;; esac'
ends_with "downloading libcli11-dev/bookworm" "downloading busybox-static:armhf/bookworm" \
  "busybox-static:armhf/bookworm cannot be downloaded: it is gone"

# begins: guest.sh as tests/run begins it beside a build.
begins() { output=$(timeout 60 bash "$here/guest.sh" "$folder" "$folder/guest" 2>&1) || { echo "downloads alone end with $?: $output"; failed=1; }; }
apt 'case "$*" in *" download "*) echo byte >package.deb ;; esac'
begins
[ -s "$folder/guest/downloads/kernels" ] && [ ! -e "$folder/guest/armhf" ] || { echo "not the downloads alone: $output"; failed=1; }
exec 7>>"$folder/guest/downloads/lock"
flock 7
timeout 60 bash "$here/guest.sh" "$folder" "$folder/guest" >"$folder/said" 2>&1 7>&- &
for ((tenths = 0; tenths < 500; ++tenths)); do
  if grep -qF "waiting for downloads that have begun" "$folder/said"; then break; fi
  sleep 0.1
done
[ "$tenths" -lt 500 ] || { echo "does not wait for others' downloads: $(cat "$folder/said")"; failed=1; }
flock --unlock 7
wait $! || { echo "downloads that had to wait end with $?: $(cat "$folder/said")"; failed=1; }
exit "$failed"
