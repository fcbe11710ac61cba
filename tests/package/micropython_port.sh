#!/usr/bin/env bash
# micropython_port.sh ROOT: ports of MicroPython name their compiler before or after they read the module's makefile. If
# the compiler lacks C++ headers, the module's flags have those of the Arm compiler.
set -euo pipefail
for tool in make arm-none-eabi-g++; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
for compiler in g++ missing-g++; do
  folders=$(make -s -f - <<PORT
CXX = \$(port_compiler)
USERMOD_DIR := $1/firmware/micropython
all:
	@echo \$(words \$(filter -isystem,\$(zstrip_flags)))
include \$(USERMOD_DIR)/micropython.mk
port_compiler = $compiler
PORT
  )
  echo "$folders folders of headers for $compiler"
  case $compiler in
    g++) [ "$folders" -eq 0 ] ;;
    *) [ "$folders" -gt 0 ] ;;
  esac
done
