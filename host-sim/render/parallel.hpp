// Runs independent pieces of work on several threads.
#pragma once

#include <cstdint>
#include <functional>

#include "result.hpp"

namespace zstrip::sim {

/// Calls work(thread, index) for every index below `count`, in order of index as threads become free. `thread` is below
/// `threads` and below `count`; no two calls with the same thread overlap. After a failure no more work is begun.
/// Returns the same as a loop would: the failure of the smallest index. Exceptions of `work` are passed on in the same
/// way.
Result<Done> for_each_on_threads(std::uint32_t count, unsigned threads,
                                 const std::function<Result<Done>(unsigned thread, std::uint32_t index)>& work);

}  // namespace zstrip::sim
