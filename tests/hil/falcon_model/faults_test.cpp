#include "hil/falcon_model/faults.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace isotouch::falcon_model {
namespace {

std::vector<Fault> read(const std::string& text) {
  std::istringstream in(text);
  return read_faults(in, "f.txt");
}

std::string complaint(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return {};
}

TEST(Faults, AreWrittenAsTheLineThatOrdersThem) {
  for (const char* line : {"at 3 unplug", "at 3 unplug 2", "at 4 corrupt", "at 4 corrupt 5 255", "at 4 corrupt 1", "at 9 short",
                           "at 20 stall 7", "at 20 encoder-jump 2 -5", "at 20 encoder-stuck 7 90", "at 0 no-wall-power"}) {
    EXPECT_EQ(line_of(read(line).at(0)), line);
  }
}

TEST(Faults, AreReadInTheOrderOfTheirPackets) {
  const std::vector<Fault> faults =
      read("# a day\n\nat 20 stall 7   # ms\nat 3 unplug\nat 20 encoder-jump 2 -5\nat 4 corrupt\nat 5 corrupt 1 0xff\n");
  EXPECT_EQ(faults, (std::vector<Fault>{{3, FaultKind::kUnplug, {0, 0}},
                                        {4, FaultKind::kCorrupt, {5, 0x20}},
                                        {5, FaultKind::kCorrupt, {1, 0xFF}},
                                        {20, FaultKind::kStall, {7, 0}},
                                        {20, FaultKind::kEncoderJump, {2, -5}}}));
}

TEST(Faults, AComplaintNamesFileLineAndRemedy) {
  EXPECT_EQ(complaint("at 1 short\nat 2 shrt\n").substr(0, 52), "f.txt:2: 'at 2 shrt' is no fault; no fault is called");
  EXPECT_EQ(complaint("at 1 stall\n"), "f.txt:1: 'at 1 stall' is no fault; write 'at PACKET stall PACKETS (1 to 1000000)'");
  EXPECT_EQ(complaint("at 1 encoder-jump 3 5\n"),
            "f.txt:1: 'at 1 encoder-jump 3 5' is no fault; write 'at PACKET encoder-jump AXIS (0 to 2) COUNTS (-32768 to 32767)'");
}

TEST(Faults, EveryMalformedLineIsRefused) {
  for (const char* line :
       {"at", "at 1", "at x short", "at -1 short", "on 1 short", "at 1 short 2", "at 1 stall 0", "at 1 stall 2x", "at 1 stall 2 3",
        "at 1 corrupt 16", "at 1 corrupt 2 0", "at 1 buttons 1", "at 1 corrupt 2 3 4", "at 99999999999999999999 short", "at 1 split"}) {
    EXPECT_FALSE(complaint(line).empty()) << line;
  }
}

}  // namespace
}  // namespace isotouch::falcon_model
