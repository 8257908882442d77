#include "firmware/daemon/hardware.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "shared/files/trace_writer.h"
#include "tests/support/chained.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::daemon {
namespace {

TEST(Hardware, ARecordingThatWasChangedIsNotReplayed) {
  const ScratchFolder folder;
  Options options;
  options.device = Options::Device::kRecorded;
  options.name = (folder.path() / "felt.trace").string();
  TraceHeader header;
  header.has_outputs = true;
  files::TraceWriter writer;
  ASSERT_FALSE(writer.begin(options.name, header));
  Chain chain(header);
  for (int tick = 0; tick < 9; ++tick) (void)writer.append(test::chained(chain, {}));
  ASSERT_FALSE(writer.finish(files::Keep::kAllOrNothing));
  const auto refusal = [&] {
    Hardware made;
    const std::atomic<bool> stop = false;
    return make_hardware(options, false, stop, made).sentence();
  };
  EXPECT_EQ(refusal(), "");
  std::fstream(options.name, std::ios::binary | std::ios::in | std::ios::out).seekp(256 + 104 * 5 + 46).put(1);
  EXPECT_EQ(refusal(),
            options.name + ": the chain breaks at record 5: its bytes were changed after they were recorded; use the original file");
}

}  // namespace
}  // namespace isotouch::daemon
