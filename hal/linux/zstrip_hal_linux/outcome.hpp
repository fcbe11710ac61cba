// Either a value, or a message for the machine's user that explains why there is no value.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace zstrip::hal {

/// `message` is one line without a full stop: the thing, what is wrong with it, what to do.
struct Fault {
  std::string message;  ///< to be shown to a user
};

/// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Outcome {
 public:
  /// Makes a success.
  Outcome(T value) : content_(std::move(value)) {}  // NOLINT(google-explicit-constructor): `return value;`
  /// Makes a failure.
  Outcome(Fault fault) : content_(std::move(fault)) {}  // NOLINT(google-explicit-constructor)

  /// True if there is a value.
  explicit operator bool() const { return std::holds_alternative<T>(content_); }
  /// @{
  /// Returns the value, which must exist.
  T& operator*() { return std::get<T>(content_); }
  const T& operator*() const { return std::get<T>(content_); }
  T* operator->() { return &std::get<T>(content_); }
  const T* operator->() const { return &std::get<T>(content_); }
  /// @}
  /// Returns the reason. Call it only if there is no value.
  const Fault& fault() const { return std::get<Fault>(content_); }

 private:
  std::variant<T, Fault> content_;
};

}  // namespace zstrip::hal
