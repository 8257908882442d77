/// Touches of a recording as frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>

#include "host/error.h"
#include "host/stream/sources.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
#include "tests/support/chained.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::stream {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kTicks = 300;

/// A hand 1 mm below a plane.
TraceRecord touch(std::uint64_t tick) {
  TraceRecord record;
  record.input = position_input({to_fixed<Mm>(static_cast<double>(tick) * 0.1), Mm::of(-1), {}});
  record.output.hip = record.input.hip;
  record.output.proxy = {record.input.hip.x, {}, {}};
  record.output.force.y = Newton::of(0.5);
  record.output.status = kContact;
  return record;
}

class RecordedTouches : public testing::Test {
 protected:
  std::filesystem::path write(const std::function<void(std::uint64_t, TraceRecord&)>& change = {}) {
    const auto file = folder_.path() / "felt.trace";
    header_.has_outputs = true;
    trace::TraceWriter writer(file, header_);
    Chain chain(header_);
    for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
      TraceRecord record = touch(tick);
      if (change) change(tick, record);
      writer.append(test::chained(chain, record));
    }
    writer.finish();
    return file;
  }
  struct Seen {
    std::size_t points = 0;  ///< of all its frames
    std::string error;
  };
  static Seen seen(const std::filesystem::path& file) {
    Inbox inbox;
    const std::jthread thread = run(recording(file, 30, false), inbox);
    Seen seen;
    try {
      while (!inbox.is_finished()) {
        if (const auto frame = inbox.take(1s)) seen.points += frame->read().positions.size();
      }
    } catch (const InputError& error) {
      seen.error = error.what();
    }
    return seen;
  }
  /// fails     the points before the refusal are others
  static void refused(const char* why, const std::filesystem::path& file, std::size_t points = 0) {
    const Seen all = seen(file);
    EXPECT_THAT(all.error, testing::HasSubstr(why));
    EXPECT_EQ(all.points, points) << why;
  }

  ScratchFolder folder_;
  TraceHeader header_;
};

TEST_F(RecordedTouches, AllComeInFrames) {
  const Seen all = seen(write());
  EXPECT_EQ(all.error, "");
  EXPECT_EQ(all.points, kTicks);
}

TEST_F(RecordedTouches, FrictionIsRefused) {
  refused("friction is set", write([](std::uint64_t tick, TraceRecord& record) {
            if (tick == 200) record.input.change = {TickSetting::kFriction, rows::kFriction.raw(0.5)};
          }),
          200);
  header_.settings.friction_damping = Damping::of(0.01);
  refused("friction_damping is set", write());
}

TEST_F(RecordedTouches, AnotherFieldIsRefusedAndAPatchedOneIsNot) {
  const auto generations = [](std::uint8_t requests) {
    return [requests](std::uint64_t tick, TraceRecord& record) {
      record.input.field_generation = tick < 50 ? 0 : tick < 200 ? 7 : 8;
      if (tick == 200) record.input.requests = requests;
    };
  };
  refused("another field was loaded while the hand touched", write(generations(0)), 200);
  EXPECT_EQ(seen(write(generations(kRequestMoved))).points, kTicks);
  const auto touched_late = [](std::uint64_t tick, TraceRecord& record) {
    record.input.field_generation = tick < 50 ? 7 : 8;
    if (tick < 60) record.output.status = 0;
  };
  EXPECT_EQ(seen(write(touched_late)).points, kTicks - 60) << "nothing was touched of the first field";
}

TEST_F(RecordedTouches, ForcesWithoutProxiesAreRefused) {
  refused("import it with --stiffness", write([](std::uint64_t, TraceRecord& record) { record.output.proxy = record.output.hip; }));
}

}  // namespace
}  // namespace isotouch::stream
