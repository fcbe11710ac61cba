// Bytes written by hand to a model of a panel, and the complaints that they are to provoke.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "panel/panel_model.hpp"

namespace zstrip::sim {

/// A hand at the lines of a panel.
struct Lines {
  PanelModel& panel;

  void send(Wire wire, std::initializer_list<int> values) {
    for (const int value : values) {
      const std::byte byte{static_cast<std::uint8_t>(value)};
      panel.receive(wire, {&byte, 1});
    }
  }
  void command(std::initializer_list<int> values) { send(Wire::command, values); }
  void data(std::initializer_list<int> values) { send(Wire::data, values); }
  void wait(Nanoseconds time) { panel.elapse(time); }
  /// A command whose parameters are data.
  void dcs(int code, std::initializer_list<int> parameters = {}) {
    command({code});
    data(parameters);
  }
};

struct Provocation {
  const char* complaint;  // the beginning
  std::function<void(Lines&)> act;
};

/// On each of fresh panels nothing but what was provoked is complained about; without acts nothing is.
template <class Model>
void expect_complaints(std::initializer_list<Provocation> provocations,
                       const std::function<std::unique_ptr<Model>()>& make, const std::function<void(Lines&)>& start) {
  for (const Provocation& provocation : provocations) {
    const auto panel = make();
    Lines lines{*panel};
    start(lines);
    EXPECT_EQ(panel->complaints(), std::vector<std::string>{});
    provocation.act(lines);
    ASSERT_EQ(panel->complaints().size(), 1U) << provocation.complaint;
    EXPECT_EQ(panel->complaints()[0].substr(0, std::string(provocation.complaint).size()), provocation.complaint);
  }
}

/// The bytes of an answer behind so many clocks.
inline std::vector<int> answer_of(PanelModel& panel, std::uint8_t command, std::size_t dummy_clocks,
                                  std::size_t bytes) {
  const std::vector<bool> bits = panel.ask(command, dummy_clocks + 8 * bytes, 150ns);
  std::vector<int> result(bytes);
  for (std::size_t i = 0; i < 8 * bytes; ++i) result[i / 8] = result[i / 8] * 2 + (bits[dummy_clocks + i] ? 1 : 0);
  return result;
}

}  // namespace zstrip::sim
