// Commands whose parameters follow as data, D/C high, as most controllers of colour panels take them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// Sends a command and its parameters; they have arrived when it returns. A bus whose commands and parameters are one
/// transfer has a function write_whole() for it (qspi.hpp).
template <CommandDataBus Bus>
Error send_command(Bus& bus, std::byte command, std::span<const std::byte> parameters = {}) {
  if constexpr (requires { bus.write_whole(command, parameters); }) return bus.write_whole(command, parameters);
  if (const Error error = bus.write_command(std::span(&command, 1)); error != Error::none) return error;
  if (parameters.empty()) return Error::none;
  if (const Error error = bus.write_data(parameters); error != Error::none) return error;
  return bus.wait();
}

/// Sends a command with parameters 0..255; they have arrived when it returns.
template <CommandDataBus Bus, std::integral First, std::integral... Rest>
Error send_command(Bus& bus, std::byte command, First first, Rest... rest) {
  const std::array parameters{static_cast<std::byte>(first), static_cast<std::byte>(rest)...};
  return send_command(bus, command, std::span<const std::byte>(parameters));
}

/// True if no command of the list is cut off. Each command is its byte, the number of its parameters, and that many
/// bytes.
constexpr bool is_command_list(std::span<const std::byte> list) {
  while (list.size() >= 2) {
    const std::size_t bytes = 2 + std::to_integer<std::size_t>(list[1]);
    if (list.size() < bytes) return false;
    list = list.subspan(bytes);
  }
  return list.empty();
}

/// Sends a list for which is_command_list() is true.
template <CommandDataBus Bus>
Error send_commands(Bus& bus, std::span<const std::byte> list) {
  while (!list.empty()) {
    const std::size_t parameters = std::to_integer<std::size_t>(list[1]);
    if (const Error error = send_command(bus, list[0], list.subspan(2, parameters)); error != Error::none) return error;
    list = list.subspan(2 + parameters);
  }
  return Error::none;
}

/// Returns the values as an array of bytes.
template <class... Values>
constexpr std::array<std::byte, sizeof...(Values)> bytes(Values... values) {
  return {static_cast<std::byte>(values)...};
}

}  // namespace zstrip::hal
