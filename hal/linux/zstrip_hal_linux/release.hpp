// Objects of C libraries as std::unique_ptr: the deleter is the library's function that frees them.
#pragma once

#include <memory>

namespace zstrip::hal {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const {
    release(object);
  }
};

template <class T, auto release>
using Owned = std::unique_ptr<T, Release<release>>;

}  // namespace zstrip::hal
