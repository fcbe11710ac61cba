// A message for the console and the panel about a failed step of a program.
#pragma once

#include "cortex_m/console.hpp"

namespace zstrip::board {

/// Both phrases are in static storage. Null `error`: success.
struct [[nodiscard]] Failure {
  const char* doing = nullptr;
  const char* error = nullptr;
  constexpr explicit operator bool() const { return error != nullptr; }
};

/// Prints one line on the console, "DOING: ERROR".
inline void print(const Failure& failure) {
  print(failure.doing);
  print(": ");
  print(failure.error);
  print("\n");
}

}  // namespace zstrip::board
