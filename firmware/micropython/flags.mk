# What the makefiles of the module share. zstrip_cxx: the C++ compiler. ZSTRIP_EFFECTS: the effects
# that the module's scenes have, of zstrip/effects.hpp.
ZSTRIP_EFFECTS ?= lighting gouraud vertex_colours textures bins overlay skins

# Debian's compiler for RISC-V has no C++ headers of its own; those of the Arm compiler fit. Only their folders are added.
# Looked for once, when the first file is compiled: some ports name their compiler after they have read this file.
zstrip_headers = $(eval zstrip_headers := $(shell $(zstrip_cxx) -E -include cstdint -x c++ /dev/null >/dev/null 2>&1 || \
  arm-none-eabi-g++ -E -v -x c++ /dev/null 2>&1 | sed -n '/backward/d;s/^ \(.*\/c++\/.*\)/\1/p'))$(zstrip_headers)
ZSTRIP_HEADERS ?= $(zstrip_headers)

zstrip_flags = -std=c++20 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
  $(addprefix -isystem ,$(ZSTRIP_HEADERS)) \
  -DZSTRIP_EFFECTS='zstrip::Effects{}$(foreach effect,$(ZSTRIP_EFFECTS),|zstrip::effect::$(effect))'
