#!/usr/bin/env bash
# Writes a C++ source that takes the tables of an object from there, byte by byte, so that they are computed once and not
# by the compiler of each processor:
#   link_tables.sh LIBRARY MEMBER SOURCE
# LIBRARY: zstrip::scenes of a processor with the same order of bytes. MEMBER: an object in it that has tables alone,
# without an address in them. SOURCE is written, and a copy of the object beside it.
# Exit status: 1 if the object has something else than tables.
set -euo pipefail
export LC_ALL=C
library=$1 member=$2 source=$3
object=${source%.cpp}.o

ar p "$library" "$member" >"$object"
readelf --sections --symbols --wide "$object" | awk -v object="$object" '
  function fail(what) { print "link_tables.sh: " object " has " what ", not only tables" > "/dev/stderr"; exit failed = 1 }
  BEGIN { print "// Written by link_tables.sh.\nasm(R\"(" }
  sub(/^ *\[ */, "") {  # a section: number], name, type, address, offset, size, entry size, flags, link, info, alignment
    if ($2 ~ /^\.rel/) fail("addresses")
    if ($2 ~ /^\.rodata\./) { offset[$1 + 0] = "0x" $5; name[$1 + 0] = $2; size[$1 + 0] = "0x" $6 }
    else if ($3 == "PROGBITS" && $8 ~ /A/ && $6 !~ /^0+$/) fail("section " $2)
  }
  $4 == "OBJECT" && $5 == "GLOBAL" { table[$7] = $8 }
  END {
    if (failed) exit 1
    for (i = 0; i < 1000; ++i) {
      if (!(i in name)) continue
      if (name[i] != ".rodata." table[i]) fail("section " name[i])
      printf ".section %s,\"a\",%%progbits\n.balign 4\n.globl %s\n.type %s, %%object\n", name[i], table[i], table[i]
      printf ".size %s, %s\n%s:\n.incbin \"%s\", %s, %s\n", table[i], size[i], table[i], object, offset[i], size[i]
    }
    print ")\");"
  }' >"$source"
