// The common parts of the models of Solomon Systech's OLED controllers: commands with parameters, on either level of
// D/C.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "panel/panel_model.hpp"

namespace zstrip::sim {

/// Codes first..last have this number of parameter bytes.
struct SolomonCommand {
  std::uint8_t first;
  std::uint8_t last;
  std::uint8_t parameters;
};

/// A window of the memory that data fills; both ends are inclusive.
struct SolomonRange {
  unsigned first = 0, last = 0, at = 0;

  /// Returns true when it starts again.
  bool advance() {
    if (at++ != last) return false;
    at = first;
    return true;
  }
};

class SolomonModel : public PanelModel {
 public:
  /// A controller whose parameters come with D/C low waits for them in any case. With D/C high, a command ends the
  /// command before.
  void interrupted() override { excused_ = true; }

 protected:
  SolomonModel(const char* name, Wire parameters_on, std::span<const SolomonCommand> commands)
      : name_(name), parameters_on_(parameters_on), commands_(commands) {}

  /// Executes a command with all its parameters.
  virtual void execute(std::uint8_t code, std::span<const std::uint8_t> parameters) = 0;
  /// Stores a byte in the memory; `last_command` is the command before it.
  virtual void store(std::uint8_t byte, std::uint8_t last_command) = 0;
  virtual void reset_registers() = 0;

  /// Returns a range of columns, rows or pages from two parameters.
  SolomonRange range_of(std::span<const std::uint8_t> parameters, unsigned limit, const char* what);
  void require(bool good, const char* what, unsigned value);

 private:
  void receive_byte(Wire wire, std::uint8_t byte) override;
  void reset() override;
  void begin(std::uint8_t code);
  void add_parameter(std::uint8_t byte);

  const char* name_;
  Wire parameters_on_;
  std::span<const SolomonCommand> commands_;
  std::uint8_t code_ = 0;
  std::size_t missing_ = 0;  // parameters
  std::vector<std::uint8_t> parameters_;
  bool excused_ = false;
};

}  // namespace zstrip::sim
