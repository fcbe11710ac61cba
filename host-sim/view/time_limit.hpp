// Ends the program when a call of a library waits for something that never answers.
#pragma once

#include <chrono>
#include <thread>

#include "result.hpp"

namespace zstrip::sim {

/// Unless it is destroyed within `time`, prints `failure` and ends the program with its status.
class TimeLimit {
 public:
  TimeLimit(std::chrono::seconds time, Failure failure);

 private:
  std::jthread watch_;
};

}  // namespace zstrip::sim
