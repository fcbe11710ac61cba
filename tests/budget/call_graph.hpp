// Who calls whom in a program for a Cortex-M, and what each function takes of the stack: read from the instructions of
// the linked program, so that nothing is missing, and where there is one compared with the compiler's own statement.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elf_file.hpp"

namespace zstrip::budget {

/// Bytes of stack that the compiler says a function takes, by the linker's name; the smallest where several have it, as
/// inline functions that files compile differently, of which the linker keeps any.
using CompilerFrames = std::map<std::string, std::uint32_t>;

/// Adds what a .ci file (GCC's -fcallgraph-info=su) says. Throws std::runtime_error if a function's frame has no bound.
void add_compiler_frames(CompilerFrames& frames, std::string_view ci);

/// A deepest call and its depth.
struct StackBound {
  std::uint32_t bytes = 0;
  std::vector<std::string> path{};  ///< functions, the outermost first
};

class CallGraph {
 public:
  /// `disassembly` is what objdump -d --no-show-raw-insn prints of `program`. Throws std::runtime_error where the
  /// compiler states a larger frame than the instructions have.
  /// A call through a pointer may reach every function whose address lies somewhere in the program outside the vector
  /// table, whose first entries are its first bytes.
  CallGraph(std::string_view disassembly, const ElfFile& program, const CompilerFrames& compiler_frames);

  /// Throws std::runtime_error if there is no such function, for recursion, and for an instruction on the way that
  /// moves the stack pointer in a way that is not understood.
  StackBound bound_of(const std::string& function) const;

 private:
  struct Function {
    std::string name;
    std::uint32_t address = 0;
    std::uint32_t frame = 0;
    std::string unknown{};  // why the frame is not known, if so
    std::vector<std::size_t> callees{};
  };
  enum class State : std::uint8_t { unseen, active, done };
  const StackBound& deepest(std::size_t index, std::vector<State>& states, std::vector<StackBound>& bounds) const;
  std::size_t index_of(const std::string& function) const;

  std::vector<Function> functions_;  // by address
};

}  // namespace zstrip::budget
