#include "host/commands/dirty_table.h"

#include <gtest/gtest.h>

namespace isotouch::commands {
namespace {

constexpr const char* kFigures[] = {"surface_rms_voxel", "truth_rms_voxel", "pieces", "volume", "wrong_side", "wrong"};

TEST(DirtyTable, JsonOfARefusedScanHasNoFigures) {
  evaluate::DirtyRow row;
  row.refused = "no points";
  row.beside.emplace().refused = "it fell over";
  const nlohmann::ordered_json json = to_json(row);
  EXPECT_EQ(json.at("refused"), "no points");
  EXPECT_TRUE(json.at("verdict").is_null()) << "of no field";
  for (const char* figure : kFigures) {
    EXPECT_TRUE(json.at(figure).is_null()) << figure;
    EXPECT_TRUE(json.at("beside").at(figure).is_null()) << figure;
  }
}

TEST(DirtyTable, JsonHasOnlyWhatWasMeasured) {
  evaluate::DirtyRow row;
  for (const bool whole : {false, true}) {
    if (whole) row.truth_rms = row.volume = 1.5;
    const nlohmann::ordered_json json = to_json(row);
    for (const char* figure : {"surface_rms_voxel", "pieces", "wrong_side"}) EXPECT_TRUE(json.at(figure).is_number()) << figure;
    for (const char* figure : {"truth_rms_voxel", "volume"}) EXPECT_EQ(json.at(figure).is_number(), whole) << figure;
    EXPECT_EQ(json.at("wrong"), whole) << "a volume of 1.5";
    EXPECT_FALSE(json.at("verdict").is_null());
    EXPECT_FALSE(json.contains("beside"));
  }
}

}  // namespace
}  // namespace isotouch::commands
