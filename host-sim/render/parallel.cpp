// A shared counter assigns the work. Indices are assigned in order, so all before a failing one have begun, and
// complete.
#include "render/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace zstrip::sim {

Result<Done> for_each_on_threads(std::uint32_t count, unsigned threads,
                                 const std::function<Result<Done>(unsigned, std::uint32_t)>& work) {
  std::atomic<std::uint32_t> next = 0;
  std::mutex mutex;  // for the three members below
  std::uint32_t first_failed = count;
  std::optional<Failure> failure;
  std::exception_ptr exception;
  std::atomic<bool> stopped = false;

  const auto fail = [&](std::uint32_t index, std::optional<Failure> reason, std::exception_ptr thrown) {
    const std::scoped_lock lock(mutex);
    stopped = true;
    if (index >= first_failed) return;
    first_failed = index;
    failure = std::move(reason);
    exception = std::move(thrown);
  };
  const auto run = [&](unsigned thread) {
    while (!stopped) {
      const std::uint32_t index = next++;
      if (index >= count) return;
      try {
        const Result<Done> done = work(thread, index);
        if (!done) fail(index, done.failure(), nullptr);
      } catch (...) {
        fail(index, std::nullopt, std::current_exception());
      }
    }
  };
  {
    std::vector<std::jthread> others;
    const unsigned wanted = std::min(threads, std::max(count, 1U));
    for (unsigned thread = 1; thread < wanted; ++thread) others.emplace_back(run, thread);
    run(0);
  }
  if (exception) std::rethrow_exception(exception);
  if (failure) return *failure;
  return Done{};
}

}  // namespace zstrip::sim
