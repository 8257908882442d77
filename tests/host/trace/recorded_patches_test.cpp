#include "host/trace/recorded_patches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/trace/felt_field.h"
#include "host/trace/replay.h"
#include "host/trace/trace_file.h"
#include "tests/support/field_image.h"
#include "tests/support/field_patch.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::trace {
namespace {

using test::FieldImage;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

FieldImage ball(double radius) {
  return FieldImage({24, 24, 24},
                    [=](const test::Point& p) {
                      return length(p - test::Point{12, 12, 12}) - radius;
                    },
                    {.edge_mm = 1.0, .band = 2.0, .origin_mm = {0, 0, 0}, .prefilter = false, .interpolation = Interpolation::kTrilinear});
}

/// A hand that presses on a ball that grows by three patches, recorded with the core itself.
class Patched : public ::testing::Test {
 protected:
  Patched() {
    for (int n = 0; n < 4; ++n) fields.push_back(ball(6 + 0.4 * n));
    for (std::size_t n = 0; n < 3; ++n) patches.push_back(test::make_patch(fields[n].view(), fields[n + 1].view()));
    RecordedPatches all{file({0, 1, 2}), 1 << 20};
    trace::Run run(fields[0].view(), {}, &all);
    TraceWriter writer(path, run.header());
    for (int t = 0; t < 400; ++t) {
      Input in = position_input({Mm::of(12), Mm::of(12), Mm::from_raw(Mm::of(22).raw() - t * ((1 << Mm::kFractionBits) / 40))});
      const auto now = static_cast<std::size_t>(std::min(t / 100, 3));
      in.field_generation = static_cast<std::uint32_t>(now + 1);
      if (t % 100 == 0 && t > 0) in.requests = kRequestMoved, in.moved_to = static_cast<std::uint32_t>(fields[now].view().hash());
      writer.append(run.step(in));
    }
    writer.finish();
    hash = run.hash();
  }
  Bytes file(const std::vector<std::size_t>& order) const {
    Bytes bytes;
    for (const std::size_t n : order) bytes.insert(bytes.end(), patches[n].begin(), patches[n].end());
    return bytes;
  }
  void keep(const Bytes& bytes) const { write_file(patches_of(path), bytes.data(), bytes.size()); }
  ReplayReport replayed() const { return replay(fields[0].view(), read_trace(path), true); }
  std::string refusal() const {
    try {
      (void)replayed();
    } catch (const InputError& e) {
      return e.what();
    }
    return "replayed";
  }

  ScratchFolder folder;
  std::filesystem::path path = folder.path() / "grown.trace";
  std::deque<FieldImage> fields;
  std::vector<Bytes> patches;
  std::uint64_t hash = 0;
};

TEST_F(Patched, EachTickHasTheFieldThatItFelt) {
  keep(file({0, 1, 2}));
  const Trace trace = read_trace(path);
  for (std::size_t given = 0; given < fields.size(); ++given) {
    FeltField felt(trace, fields[given].view());
    for (std::size_t tick = 0; tick < trace.size(); ++tick) {
      const FieldView* now = felt.next(trace.record(tick).input);
      ASSERT_EQ(now == nullptr, tick / 100 < given) << "tick " << tick << " before the patches led to field " << given;
      if (now == nullptr) continue;
      ASSERT_EQ(now->hash(), fields[tick / 100].view().hash()) << "tick " << tick;
    }
  }
  EXPECT_THROW(FeltField(trace, ball(5).view()), InputError) << "of another recording";
}

/// The last ticks, as a controller saves those around a fault: the first one took a patch over, the header names the field after it.
TEST_F(Patched, ATraceThatBeginsWithAPatchNeedsNone) {
  const Trace whole = read_trace(path);
  TraceHeader header = whole.header();
  std::vector<TraceRecord> records;
  for (std::size_t tick = 300; tick < whole.size(); ++tick) records.push_back(whole.record(tick));
  header.field_hash = fields[3].view().hash();
  const Trace end(path.string(), header, records);
  ASSERT_TRUE(begins_patched(end));
  EXPECT_FALSE(patch_bytes(end));
  FeltField felt(end, fields[3].view());
  for (const TraceRecord& record : records) ASSERT_EQ(felt.next(record.input)->hash(), header.field_hash);
  EXPECT_THROW(FeltField(end, fields[2].view()), InputError) << "no patch leads there";

  header.field_hash = fields[2].view().hash();
  EXPECT_FALSE(begins_patched(Trace(path.string(), header, records))) << "it names the field before";
}

TEST(RecordedPatches, NobodyAsksForThoseThatAControllerDoesNotKeep) {
  TraceHeader header;
  header.has_outputs = true;
  std::vector<TraceRecord> records(3);
  for (TraceRecord& record : records) {
    record.input.field_generation = 1;
    record.output.state = static_cast<std::uint16_t>(SupervisorState::kActive);
  }
  records[1].input.requests = kRequestMoved;
  const auto patches = [&] { (void)patch_bytes(Trace("crash-1.trace", header, records)); };
  EXPECT_THAT(patches, testing::ThrowsMessage<InputError>(HasSubstr("a controller keeps no patches")));
  records[0].input.requests = kRequestRestart;
  EXPECT_THAT(patches, testing::ThrowsMessage<InputError>(HasSubstr("crash-1.patches is not there; keep that file")));
}

TEST_F(Patched, ATraceReplaysWithThePatchesBesideIt) {
  keep(file({0, 1, 2}));
  const ReplayReport report = replayed();
  EXPECT_FALSE(report.first_difference);
  EXPECT_EQ(report.hash, hash);
  EXPECT_EQ(report.ticks, 400U);
}

TEST_F(Patched, WithoutItsPatchesOrWithOthersItDoesNot) {
  EXPECT_THAT(refusal(), HasSubstr("grown.patches is not there; keep that file"));
  keep(file({0, 1}));
  EXPECT_THAT(refusal(), HasSubstr("it holds 2 patches, and the trace takes 3 over; "));
  for (const auto& order : std::vector<std::vector<std::size_t>>{{1, 2}, {0, 2}, {0, 2, 1}, {2, 1, 0}}) {
    keep(file(order));
    EXPECT_THAT(refusal(), HasSubstr("grown.patches: it was made for another field; "));
  }
  Bytes cut = file({0, 1, 2});
  cut.pop_back();
  keep(cut);
  EXPECT_THAT(refusal(), HasSubstr("grown.patches: the file ends before"));
  Bytes changed = file({0, 1, 2});
  changed[500] ^= 1;
  keep(changed);
  EXPECT_THAT(refusal(), HasSubstr("grown.patches: the checksum does not match"));
}

TEST_F(Patched, MorePatchesThanATraceThatWasCutOffNeedsAreFine) {
  keep(file({0, 1, 2}));
  const Trace whole = read_trace(path);
  const std::filesystem::path other = folder.path() / "short.trace";
  TraceWriter writer(other, whole.header());
  for (std::size_t t = 0; t < 150; ++t) writer.append(whole.record(t));
  writer.finish();
  std::filesystem::copy_file(patches_of(path), patches_of(other));
  const ReplayReport report = replay(fields[0].view(), read_trace(other), true);
  EXPECT_FALSE(report.first_difference);
  EXPECT_EQ(report.hash, whole.chain(149));
}

TEST(RecordedPatches, WhereTheyHaveNoPlaceTheOldTraceStays) {
  const ScratchFolder folder;
  const std::filesystem::path trace = folder.path() / "k.trace";
  std::filesystem::create_directory(patches_of(trace));
  bool finished = false;
  EXPECT_THAT(
      [&] {
        finish_with_patches(trace, Bytes{1, 2, 3}, [&] { finished = true; });
      },
      testing::ThrowsMessage<InputError>(HasSubstr("k.patches: the patches of the trace cannot be written: it is a folder")));
  EXPECT_FALSE(finished);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "k.patches.part"));
}

TEST(RecordedPatches, ThatMayNotBeWrittenStayWithTheirTrace) {
  const ScratchFolder folder;
  const std::filesystem::path trace = folder.path() / "k.trace", patches = folder.write("k.patches", "kept");
  std::filesystem::permissions(patches, std::filesystem::perms::owner_read);
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  const pid_t child = ::fork();
  if (child == 0) {  // who is root may write everything
    if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(2);
    try {
      finish_with_patches(trace, Bytes{1, 2, 3}, [] { ::_exit(3); });
    } catch (const InputError& error) {
      ::_exit(std::string(error.what()).ends_with("cannot be written: Permission denied; name the trace otherwise") ? 0 : 4);
    }
    ::_exit(1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(std::filesystem::file_size(patches), 4U);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "k.patches.part"));
}

TEST(RecordedPatches, GetTheirNameOnlyWithTheirTrace) {
  const ScratchFolder folder;
  const std::filesystem::path trace = folder.path() / "a.trace";
  const Bytes patches = {1, 2, 3};
  EXPECT_THROW(finish_with_patches(trace, patches, [] { throw InputError("the disk is full"); }), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  finish_with_patches(trace, patches, [&] { EXPECT_FALSE(std::filesystem::exists(patches_of(trace))); });
  EXPECT_EQ(read_file(patches_of(trace)), patches);
  std::filesystem::permissions(patches_of(trace), std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  finish_with_patches(trace, patches, [] {});
  EXPECT_EQ(std::filesystem::status(patches_of(trace)).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  finish_with_patches(folder.path() / "b.trace", std::nullopt, [] {});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.patches"));
}

TEST(RecordedPatches, AreNamedAfterTheirTrace) {
  EXPECT_EQ(patches_of("a/b.trace"), "a/b.patches");
  EXPECT_EQ(patches_of("a/b.trace.part"), "a/b.patches.part") << "what a kill has left";
}

}  // namespace
}  // namespace isotouch::trace
