/// One hand on one object: recorded, replayed to the bit, and every changed bit found. A tour of all motions over a built field.
#include "host/trace/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/encoding/write_image.h"
#include "host/error.h"
#include "host/evaluate/shape_trial.h"
#include "host/field_file/open_field.h"
#include "host/motion/motion.h"
#include "host/trace/trace_file.h"
#include "shared/bytes.h"
#include "shared/crc32.h"
#include "tests/support/alloc_guard.h"
#include "tests/support/scratch_folder.h"

namespace isotouch {
namespace {

using field_file::OpenField;
using trace::Trace;
using trace::TraceWriter;

constexpr std::uint64_t kTicks = 32'000;  // a whole round, whose last motion leaves the workspace

const OpenField& capsules() {
  static const OpenField field = evaluate::trial_field(evaluate::shape_trial("capsules"), Method::kDefault);
  return field;
}

const std::vector<Input>& tour() {
  static const std::vector<Input> inputs = [] {
    std::vector<Input> made;
    motion::make_motion(&capsules().view, {.kind = "tour", .ticks = kTicks, .lost_share = 0.01},
                        [&](const Input& in) { made.push_back(in); });
    return made;
  }();
  return inputs;
}

Trace recording(const ScratchFolder& folder) {
  TraceHeader header;
  header.settings.damping = Damping::of(0.001);
  header.settings.force_limit = Newton::of(2.0);
  trace::Run run(capsules().view, header);
  TraceWriter writer(folder.path() / "tour.trace", run.header());
  for (const Input& input : tour()) writer.append(run.step(input));
  writer.finish();
  return trace::read_trace(folder.path() / "tour.trace");
}

TEST(AcrossReplay, TheTourReplaysToTheBit) {
  const ScratchFolder folder;
  const Trace trace = recording(folder);
  const auto report = trace::replay(capsules().view, trace, true);
  EXPECT_FALSE(report.first_difference.has_value());
  EXPECT_EQ(report.ticks, kTicks);
  EXPECT_EQ(report.hash, trace.chain(kTicks - 1));
}

TEST(AcrossReplay, TheTourFeelsTheObject) {
  const ScratchFolder folder;
  const Trace trace = recording(folder);
  std::uint64_t contact = 0;
  std::uint64_t force_without_contact = 0;
  std::uint32_t seen = 0;
  for (std::size_t tick = 0; tick < trace.size(); ++tick) {
    const Output out = trace.record(tick).output;
    seen |= out.status;
    contact += (out.status & kContact) != 0 ? 1U : 0U;
    force_without_contact += (out.status & kContact) == 0 && out.force != Vec3<Newton>{} ? 1U : 0U;
  }
  EXPECT_GT(contact, kTicks / 5);
  EXPECT_EQ(force_without_contact, 0U);
  EXPECT_EQ(seen & (kContact | kOutsideGrid | kForceLimited | kStale | kInputClamped),
            kContact | kOutsideGrid | kForceLimited | kStale | kInputClamped);
}

TEST(AcrossReplay, NothingIsAllocatedAfterTheStart) {
  trace::Run run(capsules().view, {});
  const std::vector<Input>& inputs = tour();
  const isotouch::test::AllocGuard guard;
  for (const Input& input : inputs) run.step(input);
  EXPECT_EQ(guard.count(), 0U);
  EXPECT_NE(run.hash(), 0U);
}

/// A field in which every distance within the band has its last bit turned, with a checksum that agrees.
OpenField changed_field() {
  const OpenField& original = capsules();
  field_file::Image image(original.image.size());
  std::copy(original.image.data(), original.image.data() + original.image.size(), image.data());
  const std::size_t at = static_cast<std::size_t>(reinterpret_cast<const std::uint8_t*>(original.view.bricks) - original.image.data());
  const int band = original.view.band.raw();
  for (std::size_t i = 0; i < image_layout::kSamplesPerBrick * original.view.brick_count; ++i) {
    if (std::abs(int{original.view.bricks[i]}) < band) image.data()[at + 2 * i] ^= 1;
  }
  store_le(image.data() + image_layout::kChecksumAt, crc32(image.data() + 16, image.size() - 16));
  return field_file::open_field(std::move(image), "changed");
}

TEST(AcrossReplay, TheLastBitOfTheFieldIsSeen) {
  const ScratchFolder folder;
  const Trace trace = recording(folder);

  field_file::Image torn(capsules().image.size());
  std::copy(capsules().image.data(), capsules().image.data() + torn.size(), torn.data());
  torn.data()[torn.size() / 2] ^= 16;
  EXPECT_THROW(field_file::open_field(std::move(torn), "torn"), InputError) << "a bit that the checksum does not know";

  const OpenField other = changed_field();
  EXPECT_THROW(trace::replay(other.view, trace, true), InputError) << "another field, whatever it holds";
  EXPECT_NE(trace::replay(other.view, trace, false).hash, trace.chain(kTicks - 1));
}

TEST(AcrossReplay, OneBitOfOneInputChangesEveryChainFromThere) {
  const ScratchFolder folder;
  const Trace before = recording(folder);
  TraceHeader header = before.header();
  trace::Run run(capsules().view, header);
  TraceWriter writer(folder.path() / "other.trace", run.header());
  constexpr std::size_t kWhere = 12'345;
  for (std::size_t tick = 0; tick < tour().size(); ++tick) {
    Input input = tour()[tick];
    if (tick == kWhere) input.hip.y = Mm::from_raw(input.hip.y.raw() ^ 1);
    writer.append(run.step(input));
  }
  writer.finish();
  const Trace after = trace::read_trace(folder.path() / "other.trace");
  const auto difference = trace::first_difference(before, after);
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->tick, kWhere);
  EXPECT_EQ(difference->field, "input.hip.y");
  for (std::size_t tick = 0; tick < kTicks; ++tick) ASSERT_EQ(before.chain(tick) == after.chain(tick), tick < kWhere) << tick;
}

}  // namespace
}  // namespace isotouch
