// Commands and their parameters.
#include "panel/solomon_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zstrip::sim {

void SolomonModel::reset() {
  missing_ = 0;
  excused_ = false;
  reset_registers();
}

void SolomonModel::receive_byte(Wire wire, std::uint8_t byte) {
  if (wire == Wire::command) {
    if (missing_ != 0 && parameters_on_ == Wire::command) return add_parameter(byte);
    if (missing_ != 0 && !excused_) complain(fmt::format("too few parameters, command {:02X}h", code_));
    excused_ = false;
    begin(byte);
  } else if (missing_ != 0 && parameters_on_ == Wire::data) {
    add_parameter(byte);
  } else if (missing_ != 0) {
    complain(fmt::format("data among the parameters of command {:02X}h", code_));
  } else {
    store(byte, code_);
  }
}

void SolomonModel::begin(std::uint8_t code) {
  code_ = code;
  parameters_.clear();
  missing_ = 0;
  const auto found = std::ranges::find_if(
      commands_, [code](const SolomonCommand& command) { return command.first <= code && code <= command.last; });
  if (found == commands_.end()) {
    complain(fmt::format("the {} has no command {:02X}h", name_, code));
    return;
  }
  missing_ = found->parameters;
  if (missing_ == 0) execute(code_, parameters_);
}

void SolomonModel::add_parameter(std::uint8_t byte) {
  parameters_.push_back(byte);
  if (--missing_ == 0) execute(code_, parameters_);
}

SolomonRange SolomonModel::range_of(std::span<const std::uint8_t> parameters, unsigned limit, const char* what) {
  const SolomonRange range{parameters[0], parameters[1], parameters[0]};
  if (range.first > range.last || range.last >= limit) {
    complain(fmt::format("{} {} to {} of {}", what, range.first, range.last, limit));
    return {0, limit - 1, 0};
  }
  return range;
}

void SolomonModel::require(bool good, const char* what, unsigned value) {
  if (!good) complain(fmt::format("{} cannot be {}", what, value));
}

}  // namespace zstrip::sim
