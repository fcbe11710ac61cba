// What the tests of `zstrip` with visibility methods share: the command in a folder of its own.
#pragma once

#include <string>

#include "../host-sim/support.hpp"

namespace zstrip::test {

using sim::test::read;

struct CommandOutcome {
  int status;
  std::string text;  ///< of both streams
};

class VisibilityCommand : public sim::test::FolderTest {
 protected:
  CommandOutcome render(const std::string& words) const { return run("render " + words); }
  /// `words` as a shell takes them.
  CommandOutcome run(const std::string& words) const {
    const auto outcome =
        sim::test::run("/bin/sh", {"-c", std::string("'") + ZSTRIP_COMMAND + "' " + words + " 2>&1"}, path("."));
    return {outcome.status, outcome.out};
  }
};

}  // namespace zstrip::test
