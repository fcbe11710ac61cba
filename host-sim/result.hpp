// Failures as values: the exit statuses of the command, and a result that holds either a value or a failure.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace zstrip::sim {

/// The exit statuses of `zstrip`; documented in README.md.
enum class ExitStatus : int {
  ok = 0,
  internal = 1,     ///< a bug in zstrip
  usage = 2,        ///< an error in the command line
  environment = 3,  ///< this machine lacks something
  input = 4,        ///< an error in the model file
  budget = 5,       ///< too little memory is allowed
  output = 6,       ///< a picture or report cannot be written
};

/// `message` is one line: the object, what is wrong with it, what to do.
struct Failure {
  ExitStatus status = ExitStatus::internal;
  std::string message;
};

/// The value of a step that returns no value.
struct Done {};

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}            // NOLINT(google-explicit-constructor): `return value;`
  Result(Failure failure) : content_(std::move(failure)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return std::holds_alternative<T>(content_); }
  T& operator*() { return std::get<T>(content_); }
  const T& operator*() const { return std::get<T>(content_); }
  T* operator->() { return &std::get<T>(content_); }
  const T* operator->() const { return &std::get<T>(content_); }
  const Failure& failure() const { return std::get<Failure>(content_); }

 private:
  std::variant<T, Failure> content_;
};

}  // namespace zstrip::sim
