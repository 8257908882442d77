/// Touches of a recording as frames.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "host/error.h"
#include "host/stream/sources.h"
#include "host/to_double.h"
#include "host/trace/trace_file.h"
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
    for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
      TraceRecord record = touch(tick);
      if (change) change(tick, record);
      writer.append(record);
    }
    writer.finish();
    return file;
  }
  /// The points of all its frames.
  static std::size_t points(const std::filesystem::path& file) {
    Inbox inbox;
    const std::jthread thread = run(recording(file, 30, false), inbox);
    struct Closed {
      Inbox& inbox;
      ~Closed() { inbox.close(); }
    } const closed{inbox};
    std::size_t count = 0;
    while (!inbox.is_finished()) {
      if (const auto frame = inbox.take(1s)) count += frame->read().positions.size();
    }
    return count;
  }
  static void refused(const char* why, const std::filesystem::path& file) {
    try {
      points(file);
      ADD_FAILURE() << "accepted: " << why;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(why));
    }
  }

  ScratchFolder folder_;
  TraceHeader header_;
};

TEST_F(RecordedTouches, AllComeInFrames) { EXPECT_EQ(points(write()), kTicks); }

TEST_F(RecordedTouches, FrictionIsRefused) {
  refused("friction is set", write([](std::uint64_t tick, TraceRecord& record) {
            if (tick == 200) record.input.change = {TickSetting::kFriction, rows::kFriction.raw(0.5)};
          }));
  header_.settings.friction_damping = Damping::of(0.01);
  refused("friction_damping is set", write());
}

TEST_F(RecordedTouches, ForcesWithoutProxiesAreRefused) {
  refused("import it with --stiffness", write([](std::uint64_t, TraceRecord& record) { record.output.proxy = record.output.hip; }));
}

}  // namespace
}  // namespace isotouch::stream
