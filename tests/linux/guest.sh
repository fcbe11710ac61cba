#!/usr/bin/env bash
# guest.sh ROOT FOLDER [PANEL [arm64]]: real Debian kernels with zstrip-panel as machines for QEMU, in
# FOLDER/{amd64,armhf}, and in FOLDER/arm64 if that word is there:
# `kernel`, `initrd`, for Arm `panels.dtb`, for armhf also `stuck-bus.dtb` (the emulator's device tree, and what
# panels.dtsi and stuck_bus.dtsi have on its GPIO chip) and `sabrelite.dtb` (the kernel's own of a board with I2C).
# PANEL is the host's program; those for Arm are built here, zstrip-panel and, for armhf with libgpiod 2 of Debian 13,
# zstrip-panel-gpiod2, for arm64 also zstrip-kernels (tests/targets).
# Downloads are kept in FOLDER/downloads; without PANEL they are all that is done, and one at a time does them, so that
# tests/run begins them while it builds. Each step is said; one is ended where FOLDER has not changed for a while, and
# not because a machine or a network is slow. Where the packages cannot be had FOLDER/missing says why, and the status is
# 77; where only those of Debian 13 cannot, FOLDER/missing-gpiod2 does, and the machines are made without the second
# program.
set -euo pipefail
root=$1 folder=$2 panel=${3-} more=${4-}
scripts=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
mkdir -p "$folder/downloads"
cd "$folder"

give_up() {
  echo "$1" >missing
  echo "$1" >&2
  exit 77
}

say() { echo "LinuxGuests: $*" >&2; }

patience=${ZSTRIP_GUEST_PATIENCE:-600}  # seconds without a new byte in FOLDER
# patiently COMMAND...: the command, ended where it makes no progress; its last line of errors then says so.
patiently() {
  local job watch status=0 ended=$folder.ended  # a file of the watch: beside FOLDER, whose size it looks at
  rm -f "$ended"
  "$@" 8>&- &
  job=$!
  (
    still=0 before=
    while [ "$still" -lt "$patience" ]; do
      sleep 1
      still=$((still + 1))
      now=$(du -sb "$folder" | cut -f 1)
      if [ "$now" != "$before" ]; then still=0 before=$now; fi
    done
    touch "$ended"
    kill "$job"
  ) >/dev/null 2>&1 8>&- &
  watch=$!
  wait "$job" || status=$?
  kill "$watch" 2>/dev/null || true
  wait "$watch" 2>/dev/null || true
  if [ -e "$ended" ]; then rm "$ended" && echo "nothing new for $patience s" >&2; fi
  return "$status"
}

exec 8>>downloads/lock
if ! flock --nonblock 8; then
  say "waiting for downloads that have begun"
  flock 8
fi
rm -f missing missing-gpiod2

for tool in apt-get dpkg-deb cpio dtc ninja qemu-system-arm qemu-system-aarch64 qemu-system-x86_64 \
  arm-linux-gnueabihf-g++ aarch64-linux-gnu-g++; do
  command -v "$tool" >/dev/null || give_up "$tool is not installed"
done

# Debian's packages for other architectures and releases, with an apt configuration of our own: the machine's stays as it
# is. The mirror is the machine's.
mirror=$(apt-get indextargets 'Created-By: Packages' --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' |
  awk '$3 == "main" && $2 !~ /security|updates/ && $1 ~ /debian\/?$/ { print $1; exit }')
[ -n "$mirror" ] || give_up "apt knows no mirror of Debian"
apt=$folder/apt
apt_options=(-o "Dir::State=$apt/state" -o "Dir::State::status=$apt/status" -o "Dir::State::Lists=$apt/lists"
  -o "Dir::Cache=$apt/cache" -o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$apt/sources"
  -o APT::Architecture=armhf -o APT::Architectures::=armhf -o APT::Architectures::=amd64 -o APT::Architectures::=arm64
  -o APT::Sandbox::User=root
  # Images of containers turn these off: then each of some fifteen calls parses the lists again, for more than a second.
  -o Dir::Cache::pkgcache=pkgcache.bin -o Dir::Cache::srcpkgcache=srcpkgcache.bin)

# add_index RELEASE ARCHITECTURE...: to those that are there.
add_index() {
  mkdir -p "$apt"/{state,lists/partial,cache/archives/partial,sources}
  touch "$apt/status"
  local source=$apt/sources/$1.sources
  printf 'Types: deb\nURIs: %s\nSuites: %s\nComponents: main\nArchitectures: %s\nSigned-By: %s\n' "$mirror" \
    "$1" "${*:2}" /usr/share/keyrings/debian-archive-keyring.gpg >"$source"
  say "downloading the index of Debian $1 for ${*:2}"
  if ! patiently apt-get "${apt_options[@]}" -o Acquire::Retries=2 update >"$apt/log" 2>&1; then
    rm "$source"
    return 1
  fi
}

# fetch PACKAGE:ARCHITECTURE/RELEASE: its file in downloads, whose name is printed. Each is downloaded once.
fetch() {
  local name=$1 kept=downloads/${1//[:\/]/_}.deb
  if [ ! -s "$kept" ]; then
    rm -rf downloads/new && mkdir downloads/new
    say "downloading $name"
    (cd downloads/new && patiently apt-get "${apt_options[@]}" download "$name") >>"$apt/log" 2>&1 ||
      give_up "$name cannot be downloaded: $(tail -n 1 "$apt/log")"
    mv downloads/new/*.deb "$kept"
  fi
  echo "$kept"
}

# The metapackage names the kernel of the day.
kernel_of() {
  apt-cache "${apt_options[@]}" show "$1" | awk '/^Version: 6\.1\./ { found = 1 }
    found && /^Depends:/ { sub(/,.*/, ""); print $2; exit }'
}

gpiod2=libgpiod-dev:armhf/trixie
names=downloads/kernels
if [ ! -s "$names" ]; then
  rm -rf "$apt/sources"
  add_index bookworm armhf amd64 arm64 || give_up "Debian's index for Arm cannot be downloaded: $(tail -n 1 "$apt/log")"
  kernels=()
  for package in linux-image-armmp:armhf linux-image-arm64:arm64 linux-image-amd64:amd64; do
    kernels+=("$(kernel_of $package)")
    [ -n "${kernels[-1]}" ] || give_up "the index of $mirror has no kernel 6.1 for ${package#*:}"
  done
  for package in libcli11-dev/bookworm {busybox-static,libgpiod-dev,libdrm-dev}:{armhf,arm64}/bookworm \
    busybox-static:amd64/bookworm "${kernels[0]}:armhf" "${kernels[1]}:arm64" "${kernels[2]}:amd64"; do
    fetch "$package" >/dev/null || exit
  done
  echo "${kernels[@]}" >"$names"
fi
read -r armhf_kernel arm64_kernel amd64_kernel <"$names"
# Mirrors serve halves of a release for hours while they copy it: that of another one shall not take the machines away.
if ! [ -s "downloads/${gpiod2//[:\/]/_}.deb" ] && ! { add_index trixie armhf && (fetch "$gpiod2") >/dev/null; }; then
  rm -f missing
  echo "$gpiod2 cannot be downloaded: $(tail -n 1 "$apt/log")" | tee missing-gpiod2
fi
exec 8>&-
if [ -z "$panel" ]; then exit; fi

unpack() { # FOLDER PACKAGE...
  local to=$1 package
  shift
  if [ -e "$to" ]; then return; fi
  mkdir -p "$to.new"
  for package in "$@"; do dpkg-deb -x "$(fetch "$package")" "$to.new"; done
  mv "$to.new" "$to"
}

# The files of kernel modules and those that they need, in the order in which they have to be loaded.
modules() { # FOLDER NAME...
  local from=$1 name file
  shift
  for name in "$@"; do
    file=$(find "$from/lib/modules" -name "${name//_/[-_]}.ko" -print -quit)
    [ -n "$file" ] || { echo "the kernel has no module $name" >&2; return 1; }
    # shellcheck disable=SC2046  # names
    modules "$from" $(tr '\0' '\n' <"$file" | sed -n 's/^depends=//p' | tr , ' ')
    echo "$file"
  done
}

pack() { # ARCHITECTURE PROGRAM MODULE...: FOLDER/ARCHITECTURE/{kernel,initrd}
  local arch=$1 program=$2 tree=$1/tree module
  shift 2
  say "packing the machine for $arch"
  rm -rf "$tree"
  mkdir -p "$tree"/{bin,dev,etc,proc,sys,tmp,modules}
  cp "$arch/packages/bin/busybox" "$tree/bin"
  cp "$program" "$tree/bin/zstrip-panel"
  for library in $(ldd "$program" 2>/dev/null | grep -o '/[^ )]*'); do install -D "$library" "$tree$library"; done
  for module in "$@"; do
    modules "$arch/packages" "$module" | awk '!seen[$0]++' >"$tree/modules/$module"
    while read -r file; do cp -n "$file" "$tree/modules"; done <"$tree/modules/$module"
    sed -i 's|.*/||' "$tree/modules/$module"
  done
  if [ -d "$arch/more" ]; then cp "$arch/more"/* "$tree/bin"; fi
  cp "$folder/scene.zsc" "$tree"
  install -m 755 "$scripts/guest_init.sh" "$tree/init"
  (cd "$tree" && find . | LC_ALL=C sort | cpio --quiet -o -H newc) | gzip -1 >"$arch/initrd"
  cp "$arch"/packages/boot/vmlinuz-* "$arch/kernel"
}

# unpack_kernel FILE: as the program that it unpacks at its start, which takes an emulated PC longer than all else of it.
# It stays as it is where there is none.
unpack_kernel() {
  local at
  for at in $(LC_ALL=C grep -abo $'\xfd7zXZ' "$1" | cut -d : -f 1); do
    tail -c "+$((at + 1))" "$1" | xz -dc >"$1.elf" 2>/dev/null || true  # behind it is something else
    if [ "$(head -c 4 "$1.elf" | tail -c 3)" = ELF ]; then mv "$1.elf" "$1" && return; fi
  done
  rm -f "$1.elf"
}

# Everything linked statically, without optimisation, which draws the same and compiles in a fifth of the time; and
# without the pipelines that the scene does not ask for.
build_panel() { # ARCHITECTURE TOOLCHAIN KERNEL: FOLDER/ARCHITECTURE/panel
  unpack "$1/packages" "busybox-static:$1/bookworm" "$3:$1"
  unpack "$1/development" "libgpiod-dev:$1/bookworm" "libdrm-dev:$1/bookworm" libcli11-dev/bookworm
  local build=(cmake -S "$root" -B "$1/build" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$root/cmake/toolchains/$2.cmake"
    "-DCMAKE_FIND_ROOT_PATH=$folder/$1/development" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0
    -DCMAKE_EXE_LINKER_FLAGS=-static -DZSTRIP_HOST_SIM=OFF -DZSTRIP_TESTS=OFF -DZSTRIP_FIRMWARE=OFF -DZSTRIP_INSTALL=OFF
    -DZSTRIP_LINUX=ON "-DZSTRIP_COMPILE_TOGETHER=whole-core;host-sim" -DZSTRIP_DEPTH_PIPELINES=OFF)
  say "building zstrip-panel for $1"
  { "${build[@]}" && patiently nice ninja -C "$1/build" zstrip-panel; } >"$1/build.log" 2>&1 ||
    { tail -n 40 "$1/build.log"; exit 1; }
  cp "$1/build/firmware/linux/zstrip-panel" "$1/panel"
}
build_panel armhf arm-linux-gnueabihf "$armhf_kernel"

# All but one file is the same with libgpiod 2, so that it is only linked again.
link_with_gpiod2() {
  unpack armhf2/development "$gpiod2"
  local objects=armhf/build/firmware/linux/CMakeFiles/zstrip-panel.dir libraries=lib/arm-linux-gnueabihf
  arm-linux-gnueabihf-g++ -std=c++20 -O1 -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror -I"$root/hal" \
    -I"$root/hal/linux" -isystem armhf2/development/usr/include \
    -c "$root/hal/linux/zstrip_hal_linux/gpio_libgpiod2.cpp" -o armhf2/gpio.o
  mapfile -t objects < <(find "$objects" -name '*.o')
  mkdir -p armhf/more
  arm-linux-gnueabihf-g++ -static -o armhf/more/zstrip-panel-gpiod2 "${objects[@]}" armhf2/gpio.o \
    armhf/build/{hal/linux/libzstrip_hal_linux,core/libzstrip_core_any,core/libzstrip_core,hal/libzstrip_hal}.a \
    armhf/development/usr/$libraries/libdrm.a armhf2/development/usr/$libraries/libgpiod.a
}
rm -rf armhf/more
if [ ! -e missing-gpiod2 ]; then link_with_gpiod2; fi
pack armhf armhf/panel virtio_pci virtio_gpu i2c_imx i2c_dev gpio_mxc spi_imx
cp armhf/packages/usr/lib/linux-image-*/imx6q-sabrelite.dtb armhf/sabrelite.dtb

# The machine's device tree with what a file of ours has on its only GPIO chip, whose power button goes. Its lines read
# low unless they are driven: on buses of I2C both lines are stuck.
tree() { # ARCHITECTURE NAME PARTS
  dtc -q -I dtb -O dts "$1/machine.dtb" | awk -v parts="$scripts/$3" '
  /^\tgpio-keys \{/ { skipping = 1 }
  !skipping { print }
  skipping && /^\t\};/ { skipping = 0 }
  /^\tpl061@/ { print "\t\tgpio-line-names = \"SCLK\", \"MOSI\", \"CS\", \"DC\", \"RESET\", \"BACKLIGHT\", \"\", \"\";"; in_chip = 1 }
  in_chip && /phandle/ { chip = $3; gsub(/[<>;]/, "", chip); in_chip = 0 }
  END { print "/ {"; while ((getline line < parts) > 0) { gsub(/CHIP/, chip, line); print line }; print "};" }
' >"$1/$2.dts"
  dtc -q -I dts -O dtb -o "$1/$2.dtb" "$1/$2.dts"
}
qemu-system-arm -M virt,highmem=off,dumpdtb=armhf/machine.dtb -cpu cortex-a15 -m 256 -display none >/dev/null 2>&1
tree armhf panels panels.dtsi  # SPI by spi-gpio, lines with names
tree armhf stuck-bus stuck_bus.dtsi

if [ "$more" = arm64 ]; then
  build_panel arm64 aarch64-linux-gnu "$arm64_kernel"
  # The kernels of NEON against the portable ones, as in user mode, but with the registers that this kernel saves.
  mkdir -p arm64/more
  printf '#include "%s"\n' "$root"/tests/targets/program/kernels.cpp "$root"/tests/kernels/*.cpp |
    aarch64-linux-gnu-g++ -std=c++20 -O1 -static -I"$root/core" -I"$root/tests/kernels" -o arm64/more/zstrip-kernels \
      -x c++ - -x none arm64/build/core/libzstrip_core.a
  pack arm64 arm64/panel virtio_pci virtio_gpu spi_gpio
  qemu-system-aarch64 -M virt,dumpdtb=arm64/machine.dtb -cpu cortex-a53 -m 256 -display none >/dev/null 2>&1
  tree arm64 panels panels.dtsi
fi

unpack amd64/packages busybox-static:amd64/bookworm "$amd64_kernel:amd64"
pack amd64 "$panel" cirrus cirrusfb bochs
unpack_kernel amd64/kernel
