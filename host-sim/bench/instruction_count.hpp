// Counts the instructions of drawing on the host, with valgrind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// How the C library sets large blocks of memory, where it has the choice.
enum class BlockStores : std::uint8_t {
  library,  ///< as it likes: on x86 with one instruction that repeats itself, of which valgrind counts every
            ///< repetition, so that clearing 2 KB and more counts as one instruction a byte
  vectors,  ///< with vector stores: counted as what they are
};

/// Instructions of one draw of everything that `zstrip bench` with these options draws; empty where valgrind is not
/// installed or cannot run this program. This program runs twice under valgrind, with --draw-each 1 and 3: the
/// difference is what two draws take, exactly, without start-up, staging and output. `what` is for the message of a
/// failure.
Result<std::optional<std::uint64_t>> count_draw(const std::vector<std::string>& options, BlockStores stores,
                                                const std::string& what);

/// Instructions per frame, averaged over the frames of `bench_case`.
Result<std::optional<std::uint64_t>> count_instructions(const BenchCase& bench_case);

}  // namespace zstrip::sim
