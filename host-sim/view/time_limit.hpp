// Ends the program if a library call waits for an answer that never comes.
#pragma once

#include <chrono>
#include <thread>

#include "result.hpp"

namespace zstrip::sim {

/// Prints `failure` and ends the program with its status, unless the object is destroyed within `time`.
class TimeLimit {
 public:
  TimeLimit(std::chrono::seconds time, Failure failure);

 private:
  std::jthread watch_;
};

}  // namespace zstrip::sim
