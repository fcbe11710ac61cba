// Names for the assembler: offsets of members, and numbers that assembly for Thumb-1 and Thumb-2 shares with C++.
//
// A layout is a macro that lists field(record, type, member, offset) and number(name, expression, value).
// ZSTRIP_CHECK_LAYOUT compares each entry with the compiler's value. ZSTRIP_NAMES gives the assembler the symbols
// .Lrecord.member and .Lname, which do not appear in the object file. The text of each function begins with the layouts
// that it uses, because assembler symbols outside of functions get lost if the linker changes the order of the files'
// code.
#pragma once

#include <cstddef>

#define ZSTRIP_CHECK_FIELD(record, type, member, offset) static_assert(offsetof(type, member) == (offset));
#define ZSTRIP_CHECK_NUMBER(name, expression, value) static_assert((expression) == (value));
#define ZSTRIP_CHECK_LAYOUT(layout) layout(ZSTRIP_CHECK_FIELD, ZSTRIP_CHECK_NUMBER)

#define ZSTRIP_NAME_FIELD(record, type, member, offset) ".set .L" #record "." #member ", " #offset "\n"
#define ZSTRIP_NAME_NUMBER(name, expression, value) ".set .L" #name ", " #value "\n"
#define ZSTRIP_NAMES(layout) layout(ZSTRIP_NAME_FIELD, ZSTRIP_NAME_NUMBER)
