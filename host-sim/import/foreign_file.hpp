// Recognises files that are not models: a web page, an archive, a picture, a model of a program too old or too new.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// The bytes of a file that foreign_kind() looks at.
inline constexpr std::size_t kBytesOfKind = 1024;

/// Returns words that begin with a verb and say what to do, or nothing for what may be a model. `begin`: the first
/// kBytesOfKind bytes of the file, or all; `ending`: of its name, in small letters (".glb").
std::optional<std::string> foreign_kind(std::string_view begin, std::string_view ending);

}  // namespace zstrip::sim
