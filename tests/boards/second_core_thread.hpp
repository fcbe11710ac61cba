// A thread in the place of a second core, and a clock for it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

namespace zstrip::hal {

struct Sleep {
  void wait(std::uint32_t microseconds) { std::this_thread::sleep_for(std::chrono::microseconds(microseconds)); }
};

/// A second core as a thread, as long as it lives.
template <class Second>
class Thread {
 public:
  explicit Thread(Second& second)
      : thread_([this, &second] {
          while (!stops_.load()) {
            if (!second.serve()) std::this_thread::yield();
          }
        }) {}
  ~Thread() {
    stops_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> stops_ = false;
  std::thread thread_;
};

}  // namespace zstrip::hal
