// Ends the program if a library call waits for an answer that never comes.
#include "view/time_limit.hpp"

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "cli/print.hpp"

namespace zstrip::sim {

TimeLimit::TimeLimit(std::chrono::seconds time, Failure failure)
    : watch_([time, failure = std::move(failure)](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any stopped;
        std::unique_lock lock(mutex);
        stopped.wait_for(lock, stop, time, [] { return false; });
        // Destructors would wait for the call, too.
        if (!stop.stop_requested()) std::_Exit(print_failure(failure));
      }) {}

}  // namespace zstrip::sim
