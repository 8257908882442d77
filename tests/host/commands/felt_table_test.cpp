#include "host/commands/felt_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace isotouch::commands {
namespace {

evaluate::FeltComparison made() {
  evaluate::FeltComparison felt;
  evaluate::FeltFigures figures;
  figures.hands = 2;
  figures.ticks = 900;
  figures.touching = 800;
  figures.errors = {{700, 1.5, 2.5, 3.5, 4.5}, {700, 0.01, 0.02, 0.03, 0.04}};
  figures.jumps = 3;
  felt.kinds = {{evaluate::FeltKind::kPress, figures}, {evaluate::FeltKind::kThin, {}}};
  felt.all = figures;
  felt.worst_direction.kind = evaluate::FeltKind::kRecorded;
  felt.worst_direction.from = "hand.trace";
  felt.worst_direction.hand = 4;
  felt.worst_direction.tick = 77;
  felt.worst_direction.direction_deg = 4.5;
  felt.worst_direction.god = {1, 2, 3};
  return felt;
}

TEST(FeltTable, JsonHasWhatScriptsReadAndNothingInventedForKindsThatComparedNothing) {
  const nlohmann::ordered_json json = felt_json(made());
  for (const char* error : {"direction_deg", "force_n"}) {
    for (const char* rank : {"median", "p95", "p99", "max"}) {
      EXPECT_TRUE(json.at("all").at(error).at(rank).is_number()) << error << ' ' << rank;
      EXPECT_TRUE(json.at("kinds").at("press").at(error).at(rank).is_number());
      EXPECT_TRUE(json.at("kinds").at("thin").at(error).at(rank).is_null());
    }
  }
  for (const char* count : {"contact_differs", "jumps", "wrong_side", "force_without_contact"}) {
    EXPECT_TRUE(json.at("all").at(count).is_number_unsigned()) << count;
    EXPECT_TRUE(json.at("kinds").at("press").at(count).is_number_unsigned());
  }
  EXPECT_EQ(json.at("all").at("jumps"), 3);
  EXPECT_EQ(json.at("all").at("direction_deg").at("p95"), 2.5);
}

TEST(FeltTable, TextNamesTheWorstPlaceWithItsMotionHandAndTick) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  print_felt(file, "field", made());
  std::rewind(file);
  std::array<char, 8192> buffer{};
  const std::string text(buffer.data(), std::fread(buffer.data(), 1, buffer.size(), file));
  std::fclose(file);
  EXPECT_NE(text.find("recorded of hand.trace, hand 4, tick 77: 4.5°"), std::string::npos) << text;
  EXPECT_NE(text.find("(1.000, 2.000, 3.000) mm"), std::string::npos) << text;
  EXPECT_NE(text.find("thin                0  no tick was compared"), std::string::npos) << text;
}

}  // namespace
}  // namespace isotouch::commands
