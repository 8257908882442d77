#include "host/motion/motion_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "host/error.h"
#include "tests/support/scratch_folder.h"

namespace isotouch::motion {
namespace {

using testing::HasSubstr;

TEST(MotionCsv, ColumnsAreFoundByNameInAnyOrder) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", "note,z_mm,y_mm,x_mm,t_s\r\n# a remark\r\nfoo,3,2,1,0\r\n\r\nbar,6,5,4,1e-3\r\n");
  const auto points = read_motion_csv(file, {});
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(points[1].position, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(points[1].time, 0.001);
}

TEST(MotionCsv, UnitsComeFromTheNameUnlessTheyAreStated) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", "stamp_ns;px_m;py_m;pz_m\n1000000000;0.001;0.002;0.003\n1500000000;0;0;0\n");
  MotionColumns columns = parse_columns("t=stamp_ns,x=px_m,y=py_m,z=pz_m");
  EXPECT_EQ(read_motion_csv(file, columns)[0].time, 1.0);
  EXPECT_NEAR(read_motion_csv(file, columns)[0].position.z(), 3.0, 1e-12);
  columns.length_unit = "in";
  EXPECT_NEAR(read_motion_csv(file, columns)[0].position.z(), 0.0762, 1e-12);
}

TEST(MotionCsv, EndingsOfNamesAreReadInFullAndMustAgree) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", "t_msec,x_meters,y_meters,z_meters\n0,+0.5,0,0\n250,0,0,0\n");
  const auto points = read_motion_csv(file, parse_columns("t=t_msec,x=x_meters,y=y_meters,z=z_meters"));
  EXPECT_EQ(points[1].time, 0.25);
  EXPECT_EQ(points[0].position.x(), 500.0);
  const auto mixed = folder.write("b.csv", "t_s,x_m,y_mm,z_mm\n0,1,1,1\n1,2,2,2\n");
  MotionColumns columns = parse_columns("x=x_m");
  EXPECT_THAT([&] { (void)read_motion_csv(mixed, columns); },
              testing::ThrowsMessage<InputError>(
                  HasSubstr("the columns 'x_m' and 'y_mm' have different units; write --length-unit for all three")));
  columns.length_unit = "mm";
  EXPECT_EQ(read_motion_csv(mixed, columns)[1].position, Eigen::Vector3d(2, 2, 2));
}

/// /proc/self/mem opens, and cannot be read at its beginning.
TEST(MotionCsv, AUnitThatIsNotReadIsRefusedAndNotTakenForAnother) {
  MotionColumns columns;
  columns.with_forces = true;
  const ScratchFolder folder;
  for (const auto& [header, column] : {std::pair{"t_min,x_mm,y_mm,z_mm,fx_N,fy_N,fz_N", "t_min"},
                                       {"t_s,x_um,y_um,z_um,fx_N,fy_N,fz_N", "x_um"},
                                       {"t_s,x_mm,y_mm,z_km,fx_N,fy_N,fz_N", "z_km"},
                                       {"t_s,x_mm,y_mm,z_mm,fx_mN,fy_mN,fz_mN", "fx_mN"}}) {
    const auto file = folder.write("unit.csv", std::string(header) + "\n0,0,0,0,0,0,0\n1,1,1,1,1,1,1\n");
    MotionColumns named = columns;
    std::string* const names[] = {&named.time, &named.x, &named.y, &named.z, &named.fx, &named.fy, &named.fz};
    std::string_view left = header;
    for (std::string* name : names) {
      *name = left.substr(0, left.find(','));
      left.remove_prefix(std::min(left.size(), name->size() + 1));
    }
    EXPECT_THAT([&] { read_motion_csv(file, named); },
                testing::ThrowsMessage<InputError>(HasSubstr("the unit of the column '" + std::string(column) + "' is not read")));
    named.time_unit = "s", named.length_unit = "mm", named.with_forces = false;
    EXPECT_EQ(read_motion_csv(file, named).size(), 2U) << "a stated unit counts";
  }
}

TEST(MotionCsv, ALineWithoutEndIsRefusedAndNoSentenceIsLong) {
  const ScratchFolder folder;
  EXPECT_THAT([&] { read_motion_csv(folder.write("endless.csv", std::string(3'000'000, 'a')), {}); },
              testing::ThrowsMessage<InputError>(HasSubstr("line 1: has no end within 64 KiB")));
  const std::string long_name(10'000, 'b');
  std::string names = long_name;
  for (int i = 0; i < 1000; ++i) names += ",c" + std::to_string(i);
  try {
    read_motion_csv(folder.write("names.csv", names + "\n1,2,3\n"), {});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("and 981 more"));
    EXPECT_LT(std::string(error.what()).size(), 1000U);
  }
}

TEST(MotionCsv, AFileThatCannotBeReadToItsEndIsNoShortOne) {
  EXPECT_THAT([] { (void)read_motion_csv("/proc/self/mem", {}); },
              testing::ThrowsMessage<InputError>(HasSubstr("cannot be read to its end")));
}

TEST(MotionCsv, EveryMalformedTableGetsItsSentence) {
  const std::string head = "t_s,x_mm,y_mm,z_mm\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", "is empty"},
      {head, "holds 0 rows"},
      {"\x89MCAP0\r\nrest", "is no text, but a table of times and positions is expected; name a recording"},
      {std::string("SQLite format 3\0rest", 20), "is no text"},
      {head + "0,1,2,3\n", "holds 1 rows"},
      {"t,x_mm,y_mm,z_mm\n0,0,0,0\n1,1,1,1\n", "line 1: no column is called 't_s', there are: t x_mm y_mm z_mm"},
      {"t_s,x_mm,y_mm,x_mm,z_mm\n0,0,0,0,0\n1,1,1,1,1\n", "line 1: two columns are called 'x_mm'"},
      {head + "0,1,2,3\n1,1,nan,3\n", "line 3: 'nan' in column 'y_mm' is not a finite number"},
      {head + "0,1,2,3\n1,inf,2,3\n", "line 3: 'inf' in column 'x_mm'"},
      {head + "0,1,2,3\n1,,2,3\n", "line 3: '' in column 'x_mm'"},
      {head + "0,1,2,3\n1,1.5abc,2,3\n", "line 3: '1.5abc' in column 'x_mm'"},
      {head + "0,1,2,3\n1,1e999,2,3\n", "line 3: '1e999' in column 'x_mm'"},
      {head + "0,1,2,3\n1,2,3\n", "line 3: has 3 fields where the header names 4"},
      {head + "0,1,2,3\n1,1,2,3\n1,1,2,3\n", "line 4: the time 1 does not come after"},
      {head + "0,1,2,3\n2,1,2,3\n1,1,2,3\n", "line 4: the time 1 does not come after"},
  };
  for (const auto& [text, sentence] : cases) {
    const ScratchFolder folder;
    const auto file = folder.write("bad.csv", text);
    try {
      read_motion_csv(file, {});
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.string())) << text;
      EXPECT_THAT(error.what(), HasSubstr(sentence)) << text;
    }
  }
  const ScratchFolder folder;
  EXPECT_THROW(read_motion_csv(folder.path() / "missing.csv", {}), InputError);
  EXPECT_THROW(read_motion_csv(folder.path(), {}), InputError);
}

TEST(MotionCsv, AColumnChoiceThatIsNoneIsRefused) {
  for (const char* text : {"q=t", "t", "t=", "t=a,,x=b"}) EXPECT_THROW(parse_columns(text), InputError) << text;
  MotionColumns furlongs;
  furlongs.length_unit = "furlong";
  const ScratchFolder folder;
  EXPECT_THROW(read_motion_csv(folder.write("a.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n1,1,1,1\n"), furlongs), InputError);
}

TEST(MotionCsv, ForcesAreReadOnlyWhereTheyAreWanted) {
  const ScratchFolder folder;
  const auto file = folder.write("a.csv", "t_s,x_mm,y_mm,z_mm,fx_N,fy_N,gz\n0,1,2,3,4,5,6\n1,1,2,3,7,8,9\n");
  EXPECT_EQ(read_motion_csv(file, {})[1].force, Eigen::Vector3d(0, 0, 0));
  MotionColumns columns = parse_columns("fz=gz");
  columns.with_forces = true;
  EXPECT_EQ(read_motion_csv(file, columns)[1].force, Eigen::Vector3d(7, 8, 9));
  columns.fz = "fz_N";
  EXPECT_THROW(read_motion_csv(file, columns), InputError);
}

TEST(MotionCsv, RecordedHandsAreRead) {
  const char* data = std::getenv("ISOTOUCH_DATA");
  if (data == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA is not set";
  const auto points = read_motion_csv(std::string(data) + "/traces/touch_sharedcontrol_a_0.csv", {});
  EXPECT_EQ(points.size(), 295U);
  EXPECT_NEAR(points[0].position.y(), -83.824997, 1e-9);
}

}  // namespace
}  // namespace isotouch::motion
