#!/usr/bin/env bash
# guest.sh ROOT FOLDER PANEL: real Debian kernels with zstrip-panel as machines for QEMU, in FOLDER/amd64 and FOLDER/armhf:
# `kernel`, `initrd`, for armhf `panels.dtb` and `stuck-bus.dtb` (the emulator's device tree, and what panels.dtsi and
# stuck_bus.dtsi have on its GPIO chip) and `sabrelite.dtb` (the kernel's own of a board with I2C). PANEL is the host's
# program; those for armhf are built here, zstrip-panel and, with libgpiod 2 of Debian 13, zstrip-panel-gpiod2.
# Downloads are kept in FOLDER/downloads. Where the packages cannot be had FOLDER/missing says why, and the status is 77;
# where only those of Debian 13 cannot, FOLDER/missing-gpiod2 does, and the machines are made without the second program.
set -euo pipefail
root=$1 folder=$2 panel=$3
scripts=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
mkdir -p "$folder/downloads"
cd "$folder"
rm -f missing missing-gpiod2

give_up() {
  echo "$1" >missing
  echo "$1" >&2
  exit 77
}

for tool in apt-get dpkg-deb cpio dtc qemu-system-arm qemu-system-x86_64 arm-linux-gnueabihf-g++; do
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
  -o APT::Architecture=armhf -o APT::Architectures::=armhf -o APT::Architectures::=amd64 -o APT::Sandbox::User=root)

# add_index RELEASE ARCHITECTURE...: to those that are there.
add_index() {
  mkdir -p "$apt"/{state,lists/partial,cache/archives/partial,sources}
  touch "$apt/status"
  local source=$apt/sources/$1.sources
  printf 'Types: deb\nURIs: %s\nSuites: %s\nComponents: main\nArchitectures: %s\nSigned-By: %s\n' "$mirror" \
    "$1" "${*:2}" /usr/share/keyrings/debian-archive-keyring.gpg >"$source"
  if ! timeout 300 apt-get "${apt_options[@]}" -o Acquire::Retries=2 update >"$apt/log" 2>&1; then
    rm "$source"
    return 1
  fi
}

# fetch PACKAGE:ARCHITECTURE/RELEASE: its file in downloads, whose name is printed. Each is downloaded once.
fetch() {
  local name=$1 kept=downloads/${1//[:\/]/_}.deb
  if [ ! -s "$kept" ]; then
    rm -rf downloads/new && mkdir downloads/new
    (cd downloads/new && timeout 300 apt-get "${apt_options[@]}" download "$name") >>"$apt/log" 2>&1 ||
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

armhf_packages="busybox-static:armhf/bookworm libgpiod-dev:armhf/bookworm libdrm-dev:armhf/bookworm
  libcli11-dev/bookworm" gpiod2=libgpiod-dev:armhf/trixie
names=downloads/names
if [ ! -s "$names" ]; then
  rm -rf "$apt/sources"
  add_index bookworm armhf amd64 || give_up "Debian's index for armhf cannot be downloaded: $(tail -n 1 "$apt/log")"
  armhf_kernel=$(kernel_of linux-image-armmp:armhf) amd64_kernel=$(kernel_of linux-image-amd64:amd64)
  [ -n "$armhf_kernel" ] && [ -n "$amd64_kernel" ] || give_up "the index of $mirror has no kernel 6.1"
  for package in $armhf_packages busybox-static:amd64/bookworm "$armhf_kernel:armhf" "$amd64_kernel:amd64"; do
    fetch "$package" >/dev/null || exit
  done
  echo "$armhf_kernel $amd64_kernel" >"$names"
fi
read -r armhf_kernel amd64_kernel <"$names"
# Mirrors serve halves of a release for hours while they copy it: that of another one shall not take the machines away.
if ! [ -s "downloads/${gpiod2//[:\/]/_}.deb" ] && ! { add_index trixie armhf && (fetch "$gpiod2") >/dev/null; }; then
  rm -f missing
  echo "$gpiod2 cannot be downloaded: $(tail -n 1 "$apt/log")" | tee missing-gpiod2
fi

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
  if [ "$arch" = armhf ] && [ ! -e missing-gpiod2 ]; then cp armhf2/zstrip-panel "$tree/bin/zstrip-panel-gpiod2"; fi
  cp "$folder/scene.zsc" "$tree"
  install -m 755 "$scripts/guest_init.sh" "$tree/init"
  (cd "$tree" && find . | LC_ALL=C sort | cpio --quiet -o -H newc) | gzip -1 >"$arch/initrd"
  cp "$arch"/packages/boot/vmlinuz-* "$arch/kernel"
}

# armhf: everything linked statically, without optimisation, which draws the same and compiles in a fifth of the time; and
# without the pipelines that the scene does not ask for.
unpack armhf/packages busybox-static:armhf/bookworm "$armhf_kernel:armhf"
unpack armhf/development libgpiod-dev:armhf/bookworm libdrm-dev:armhf/bookworm libcli11-dev/bookworm
build=(cmake -S "$root" -B armhf/build -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$root/cmake/toolchains/arm-linux-gnueabihf.cmake"
  "-DCMAKE_FIND_ROOT_PATH=$folder/armhf/development" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0
  -DCMAKE_EXE_LINKER_FLAGS=-static -DZSTRIP_HOST_SIM=OFF -DZSTRIP_TESTS=OFF -DZSTRIP_FIRMWARE=OFF -DZSTRIP_INSTALL=OFF
  -DZSTRIP_LINUX=ON -DZSTRIP_COMPILE_TOGETHER=core -DZSTRIP_SELDOM_PIPELINES=OFF)
{ "${build[@]}" && nice cmake --build armhf/build --target zstrip-panel; } >armhf/build.log 2>&1 ||
  { tail -n 40 armhf/build.log; exit 1; }

# All but one file is the same with libgpiod 2, so that it is only linked again.
link_with_gpiod2() {
  unpack armhf2/development "$gpiod2"
  local objects=armhf/build/firmware/linux/CMakeFiles/zstrip-panel.dir libraries=lib/arm-linux-gnueabihf
  arm-linux-gnueabihf-g++ -std=c++20 -O1 -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror -I"$root/hal" \
    -I"$root/hal/linux" -isystem armhf2/development/usr/include \
    -c "$root/hal/linux/zstrip_hal_linux/gpio_libgpiod2.cpp" -o armhf2/gpio.o
  mapfile -t objects < <(find "$objects" -name '*.o')
  arm-linux-gnueabihf-g++ -static -o armhf2/zstrip-panel "${objects[@]}" armhf2/gpio.o \
    armhf/build/{hal/linux/libzstrip_hal_linux,core/libzstrip_core_any,core/libzstrip_core,hal/libzstrip_hal}.a \
    armhf/development/usr/$libraries/libdrm.a armhf2/development/usr/$libraries/libgpiod.a
}
if [ ! -e missing-gpiod2 ]; then link_with_gpiod2; fi
pack armhf armhf/build/firmware/linux/zstrip-panel virtio_pci virtio_gpu i2c_imx i2c_dev gpio_mxc spi_imx
cp armhf/packages/usr/lib/linux-image-*/imx6q-sabrelite.dtb armhf/sabrelite.dtb

# The machine's device tree with what a file of ours has on its only GPIO chip, whose power button goes. Its lines read low
# unless they are driven: on buses of I2C both lines are stuck.
tree() { # NAME PARTS
  dtc -q -I dtb -O dts armhf/machine.dtb | awk -v parts="$scripts/$2" '
  /^\tgpio-keys \{/ { skipping = 1 }
  !skipping { print }
  skipping && /^\t\};/ { skipping = 0 }
  /^\tpl061@/ { print "\t\tgpio-line-names = \"SCLK\", \"MOSI\", \"CS\", \"DC\", \"RESET\", \"BACKLIGHT\", \"\", \"\";"; in_chip = 1 }
  in_chip && /phandle/ { chip = $3; gsub(/[<>;]/, "", chip); in_chip = 0 }
  END { print "/ {"; while ((getline line < parts) > 0) { gsub(/CHIP/, chip, line); print line }; print "};" }
' >"armhf/$1.dts"
  dtc -q -I dts -O dtb -o "armhf/$1.dtb" "armhf/$1.dts"
}
qemu-system-arm -M virt,highmem=off,dumpdtb=armhf/machine.dtb -cpu cortex-a15 -m 256 -display none >/dev/null 2>&1
tree panels panels.dtsi  # SPI by spi-gpio, lines with names
tree stuck-bus stuck_bus.dtsi

unpack amd64/packages busybox-static:amd64/bookworm "$amd64_kernel:amd64"
pack amd64 "$panel" cirrus cirrusfb bochs
