// Names of symbols for readers: without what tells the compiler more than them.
#pragma once

#include <string>

namespace zstrip::budget {

/// A symbol's name without return type, parameters, the namespaces that all of zstrip is in, and sets of effects among
/// its template arguments. Several functions may share it: draw_strip of every set of effects, parts that the compiler
/// has split off.
std::string reader_name(const std::string& symbol);

/// A reader_name without any template argument.
std::string without_arguments(const std::string& reader_name);

}  // namespace zstrip::budget
