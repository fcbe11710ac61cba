// Who answers: drivers that ask a controller for its id before they send it anything, and what they make of another
// one, of nobody, and of a bus that fails meanwhile.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "bench.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::panels {
namespace {

template <class C>
class PanelIdentity : public testing::Test {
 protected:
  /// With the id that the data sheet, or who has such a part, says.
  static hal::DcsConfig asked() {
    hal::DcsConfig config = C::configs().front();
    config.id = C::kId;
    return config;
  }
};
template <class C, std::uint32_t id>
struct WithId : C {
  static constexpr std::uint32_t kId = id;
};
using Controllers = testing::Types<WithId<St7789, 0x858552>, WithId<Ili9341, 0x009341>, WithId<St7735, 0x7C89F0>,
                                   WithId<St7735Gm11, 0x7C89F0>, WithId<Gc9a01, 0x009A01>, WithId<St7796, 0x007796>,
                                   WithId<Ili9342, 0x009342>, WithId<Ili9488, 0x009488>>;
struct Names {
  template <class C>
  static std::string GetName(int /*index*/) {
    return C::name();
  }
};
TYPED_TEST_SUITE(PanelIdentity, Controllers, Names);

template <class C>
void expect_picture(Bench<C>& bench) {
  std::mt19937 random(5);
  const Picture picture = noise(bench.display.width(), bench.display.height(), bench.display.format(), random);
  ASSERT_EQ(bench.write(bench.whole(), picture), Error::none);
  EXPECT_EQ(bench.fault(), "");
}

TYPED_TEST(PanelIdentity, TheRightOneStarts) {
  Bench<TypeParam> bench(this->asked());
  std::uint32_t id = 0;
  EXPECT_EQ(bench.display.read_id(id), Error::none);
  EXPECT_EQ(id, TypeParam::kId);
  ASSERT_EQ(bench.display.start(), Error::none);
  expect_picture(bench);
  EXPECT_EQ(bench.display.read_id(id), Error::none) << "also when it is awake";
  EXPECT_EQ(id, TypeParam::kId);
  expect_picture(bench);
}

TYPED_TEST(PanelIdentity, AnotherOneIsSentNothingAndTheRightOneStartsAfterIt) {
  hal::DcsConfig config = this->asked();
  config.id ^= 0x000100;
  Bench<TypeParam> bench(config);
  const int before = bench.bus.transfers();
  std::uint32_t id = 0;
  ASSERT_EQ(bench.display.read_id(id), Error::none);
  const int of_a_question = bench.bus.transfers() - before;
  EXPECT_EQ(bench.display.start(), Error::wrong_id);
  EXPECT_EQ(bench.bus.transfers(), before + 2 * of_a_question) << "nothing but the question";
  EXPECT_FALSE(bench.panel->darkness().empty());
  EXPECT_EQ(bench.panel->complaints(), std::vector<std::string>{});

  auto right = TypeParam::driver(bench.bus, this->asked());
  ASSERT_EQ(right.start(), Error::none);
  expect_picture(bench);
}

TYPED_TEST(PanelIdentity, WithoutAWireNobodyAnswersAndWhoDoesNotAskStarts) {
  for (const sim::AnswerWire wire : {sim::AnswerWire::low, sim::AnswerWire::high}) {
    Bench<TypeParam> bench(this->asked());
    bench.bus.wire_answers(wire);
    EXPECT_EQ(bench.display.start(), Error::wrong_id);
    std::uint32_t id = 1;
    EXPECT_EQ(bench.display.read_id(id), Error::none);
    EXPECT_EQ(id, wire == sim::AnswerWire::low ? 0U : 0xFFFFFFU);

    auto silent = TypeParam::driver(bench.bus, TypeParam::configs().front());
    ASSERT_EQ(silent.start(), Error::none);
    expect_picture(bench);
  }
}

TYPED_TEST(PanelIdentity, AStartThatBreaksOffAtAnyStepIsReportedAndCanBeRepeated) {
  int transfers = 0;
  {
    Bench<TypeParam> bench(this->asked());
    ASSERT_EQ(bench.display.start(), Error::none);
    transfers = bench.bus.transfers();
  }
  for (int at = 0; at < transfers; ++at) {
    for (const unsigned arriving : {0U, 2U}) {
      SCOPED_TRACE(testing::Message() << "transfer " << at << ", " << arriving << " quarters arrive");
      Bench<TypeParam> bench(this->asked());
      bench.bus.fail_at(at, arriving);
      ASSERT_EQ(bench.display.start(), Error::bus);
      ResetLine reset{bench.panel.get()};
      ASSERT_EQ(hal::reset_panel(reset, bench.bus), Error::none);
      ASSERT_EQ(bench.display.start(), Error::none);
      ASSERT_EQ(bench.fault(), "");
    }
  }
}

// A wire that nobody drives would read as the first, and the others never match.
TYPED_TEST(PanelIdentity, IdsThatNoControllerCanHaveAreRefused) {
  for (const std::uint32_t id : {0xFFFFFFU, 0x1000000U, 0x1858552U, 0xFFFFFFFFU}) {
    hal::DcsConfig config = this->asked();
    config.id = id;
    Bench<TypeParam> bench(config);
    bench.bus.wire_answers(sim::AnswerWire::high);
    EXPECT_EQ(bench.display.start(), Error::configuration) << id;
    EXPECT_EQ(bench.bus.transfers(), 0) << id;
  }
}

// A driver that believes in another controller than the one that is there.
TEST(PanelIdentities, EachIsAnotherOneToTheOthers) {
  Bench<St7789> bench(St7789::configs().front());
  hal::DcsConfig config = Ili9341::configs().front();
  config.id = hal::Ili9341Controller::kId;
  Ili9341::Driver ili9341(bench.bus, bench.bus, config);
  EXPECT_EQ(ili9341.start(), Error::wrong_id);
  config.id = hal::St7735Controller::kId;
  St7735::Driver st7735(bench.bus, bench.bus, config);
  EXPECT_EQ(st7735.start(), Error::wrong_id);
}

TEST(PanelIdentities, ABusThatCannotReadIsNotAskedTo) {
  struct WriteOnly {
    sim::ModelBus& bus;
    Error write_command(std::span<const std::byte> bytes) { return bus.write_command(bytes); }
    Error write_data(std::span<const std::byte> bytes) { return bus.write_data(bytes); }
    Error wait() { return bus.wait(); }
  };
  static_assert(hal::CommandDataBus<WriteOnly> && !hal::ReadableBus<WriteOnly>);
  Bench<St7789> bench(St7789::configs().front());
  WriteOnly bus{bench.bus};
  hal::St7789 asking(bus, bench.bus, {.width = 240, .height = 240, .id = hal::St7789Controller::kId});
  EXPECT_EQ(asking.start(), Error::configuration);
  EXPECT_EQ(bench.bus.transfers(), 0);
  hal::St7789 silent(bus, bench.bus, bench.config);
  EXPECT_EQ(silent.start(), Error::none);
  EXPECT_EQ(bench.fault(), "");
}

}  // namespace
}  // namespace zstrip::panels
