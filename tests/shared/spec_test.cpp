/// SPEC.md against the lists that the code is made of. Where a table differs, the test prints the one that belongs there.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "shared/device_model.h"
#include "shared/settings_table.h"
#include "shared/tick_io.h"
#include "shared/trace.h"

namespace isotouch {
namespace {

std::string spec() {
  std::ifstream file(ISOTOUCH_SPEC);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string range_of(const SettingRow& row) {
  return number(row.low) + " to " + number(row.high) + (row.zero_means_unset ? ", or 0: unset" : "");
}

/// | name | unit | fraction bits | range | … as a row of either table has them
std::string cells_of(const SettingRow& row) {
  return std::string(row.name) + " | " + (row.unit.empty() ? std::string("") : std::string(row.unit)) + " | " +
         std::to_string(row.fraction_bits) + " | " + range_of(row) + " | ";
}

TEST(Spec, TheTableOfSettingsIsThatOfTheCode) {
  std::string table =
      "| number | name | unit | fraction bits | range | default | may change | meaning |\n|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < kTickSettings; ++i) {
    const SettingRow& row = *kTickSettingRows[i];
    table += "| " + std::to_string(i + 1) + " | " + cells_of(row) + number(row.standard) + " | " + (i < kLiveSettings ? "yes" : "no") +
             " | " + std::string(row.meaning) + " |\n";
  }
  EXPECT_NE(spec().find(table), std::string::npos) << "SPEC.md, 3.1 must hold this table:\n" << table;
}

TEST(Spec, TheBitsOfATickAreThoseOfTheCode) {
  const std::vector<std::pair<std::string, std::uint32_t>> bits = {
      {"contact", kContact},
      {"following", kFollowing},
      {"outside grid", kOutsideGrid},
      {"held inside", kHeldInside},
      {"ramping", kRamping},
      {"force limited", kForceLimited},
      {"stale", kStale},
      {"input clamped", kInputClamped},
      {"bad reply", kBadReply},
      {"count jump", kCountJump},
      {"pose uncertain", kPoseUncertain},
      {"near singular", kNearSingular},
      {"too fast", kTooFast},
      {"commands limited", kCommandsLimited},
      {"slew limited", kSlewLimited},
      {"heat limited", kHeatLimited},
      {"late", kLate},
      {"damped", kDamped},
      {"lagging", kLagging},
      {"stopped", kFaultStopped},
      {"silent", kFaultSilent},
      {"penetration", kFaultPenetration},
      {"encoders", kFaultEncoders},
      {"pose", kFaultPose},
      {"speed", kFaultSpeed},
      {"late", kFaultLate},
      {"emergency", kFaultEmergency},
      {"enable", kFaultEnable},
      {"memory", kFaultMemory},
      {"guard", kFaultGuard},
  };
  const std::string text = spec();
  for (const auto& [name, value] : bits) {
    const std::string row = "| " + std::to_string(std::countr_zero(value)) + " | " + name + " | ";
    EXPECT_NE(text.find(row), std::string::npos) << "SPEC.md, section 3 must have a row that begins with: " << row;
  }
}

TEST(Spec, TheTableOfTheDeviceModelIsThatOfTheCode) {
  std::string table = "| offset | size | name | unit | fraction bits | range | meaning |\n|---|---|---|---|---|---|---|\n";
  std::size_t offset = 0, leg_bytes = 0;
  const DeviceModel model;
  for_each_number(model, [&](const SettingRow* row, const auto& value) {
    if (row == nullptr) {
      leg_bytes += sizeof(value);
    } else {
      if (leg_bytes > 0)
        table +=
            "| " + std::to_string(offset - leg_bytes) + " | " + std::to_string(leg_bytes) + " | legs | | | | three legs, see above |\n";
      leg_bytes = 0;
      table += "| " + std::to_string(offset) + " | " + std::to_string(sizeof(value)) + " | " + cells_of(*row) + std::string(row->meaning) +
               " |\n";
    }
    offset += sizeof(value);
  });
  table += "| " + std::to_string(offset) + " | " + std::to_string(kDeviceModelBytes - offset) + " | reserved | | | | zero |\n";
  EXPECT_NE(spec().find(table), std::string::npos) << "SPEC.md, section 5 must hold this table:\n" << table;
}

/// A line of a layout table begins with offset, size and name.
bool holds_line(const std::string& text, std::size_t offset, std::size_t size, const std::string& name) {
  std::istringstream lines(text);
  const std::regex wanted("^" + std::to_string(offset) + " +" + std::to_string(size) + " +" +
                          std::regex_replace(name, std::regex(R"(\.)"), "\\.") + "( .*)?$");
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, wanted)) return true;
  }
  return false;
}

TEST(Spec, EveryFieldOfATraceStandsWhereTheCodeHasIt) {
  using namespace trace_layout;
  const std::string text = spec();
  const std::string trace = text.substr(text.find("## 3. Trace"), text.find("### 3.1 ") - text.find("## 3. Trace"));
  std::size_t fields = 0;
  for (const FieldList* list : {&kPositionFields, &kPacketFields}) {
    for (std::size_t i = 0; i < list->count; ++i, ++fields) {
      const Field& field = list->fields[i];
      EXPECT_TRUE(holds_line(trace, field.offset, field.size, std::string(field.name)))
          << field.offset << " " << field.size << " " << field.name;
    }
  }
  TraceHeader header;
  FieldList list;
  header_fields(header, list);
  for (std::size_t i = 0; i < list.count; ++i, ++fields) {
    const Field& field = list.fields[i];
    EXPECT_TRUE(holds_line(trace, kFieldsAt + field.offset, field.size, std::string(field.name)))
        << kFieldsAt + field.offset << " " << field.size << " " << field.name;
  }
  EXPECT_EQ(fields, kPositionFields.count + kPacketFields.count + 7);
  EXPECT_TRUE(holds_line(trace, 4, 2, "major")) << "with version " << trace_layout::kMajor;
  EXPECT_NE(trace.find("## 3. Trace, version " + std::to_string(trace_layout::kMajor)), std::string::npos);
  const std::string prose = std::regex_replace(trace, std::regex(R"(\s+)"), " ");  // wherever its lines break
  EXPECT_NE(prose.find("bytes 0 to " + std::to_string(kChainAt - 1) + " of record n"), std::string::npos);
  EXPECT_NE(prose.find("bytes " + std::to_string(kHeaderChainAt) + " to " + std::to_string(kHeaderChainAt + kHeaderChainBytes - 1) +
                       " of the header"),
            std::string::npos);
}

}  // namespace
}  // namespace isotouch
