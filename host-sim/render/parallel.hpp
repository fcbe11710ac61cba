// Independent pieces of work on several threads.
#pragma once

#include <cstdint>
#include <functional>

#include "result.hpp"

namespace zstrip::sim {

/// Calls work(thread, index) for every index below `count`, in order of index as threads become free; `thread` is below
/// `threads` and below `count`, and no two calls with the same one overlap. After a failure nothing more is begun. What
/// it returns is what a loop would: the failure of the smallest index. Exceptions of `work` come out of it likewise.
Result<Done> for_each_on_threads(std::uint32_t count, unsigned threads,
                                 const std::function<Result<Done>(unsigned thread, std::uint32_t index)>& work);

}  // namespace zstrip::sim
