#include "host/motion/motion_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

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
  EXPECT_EQ(read_motion_csv(file, columns)[1].time, 0.5) << "since the first sample";
  EXPECT_NEAR(read_motion_csv(file, columns)[0].position.z(), 3.0, 1e-12);
  columns.length_unit = "in";
  EXPECT_NEAR(read_motion_csv(file, columns)[0].position.z(), 0.0762, 1e-12);
}

TEST(MotionCsv, NoDigitOfATimeSince1970IsLost) {
  const ScratchFolder folder;
  const auto since = [&](const std::string& column, const std::string& first, const std::string& second) {
    const auto file = folder.write("a.csv", column + ",x_mm,y_mm,z_mm\n" + first + ",0,0,0\n" + second + ",1,1,1\n");
    return read_motion_csv(file, parse_columns("t=" + column))[1].time;
  };
  EXPECT_NEAR(since("t_s", "1700000000.001", "1700000000.0020001"), 0.0010001, 1e-15);
  EXPECT_NEAR(since("t_s", "1700000000.9", "1700000001"), 0.1, 1e-15);
  EXPECT_NEAR(since("t_ns", "1700000000123456788", "1700000000123456789"), 1e-9, 1e-20);
  EXPECT_NEAR(since("t_s", "-0.5", "-.25"), 0.25, 1e-15);
  EXPECT_NEAR(since("t_s", "-1.5", "+1e-1"), 1.6, 1e-15);
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

/// What is read of a table whose times and places have these names and are 0 and 2; nothing where it is refused.
std::optional<TimedPoint> second_row(const std::string& time, const std::string& place, const char* time_unit = "",
                                     const char* length_unit = "") {
  const ScratchFolder folder;
  MotionColumns columns;
  columns.time = time, columns.time_unit = time_unit, columns.length_unit = length_unit;
  columns.x = "x" + place, columns.y = "y" + place, columns.z = "z" + place;
  const std::string header = time + "," + columns.x + "," + columns.y + "," + columns.z;
  try {
    return read_motion_csv(folder.write("names.csv", header + "\n0,0,0,0\n2,2,2,2\n"), columns)[1];
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AnyOf(HasSubstr("none of the known units"), HasSubstr("is only a unit")));
    return std::nullopt;
  }
}

TEST(MotionCsv, TheLastWordOfANameIsItsUnit) {
  for (const auto& [place, millimetres] : {std::pair{"", 2.0},
                                           {"Left", 2.0},
                                           {"_mm", 2.0},
                                           {"_MM", 2.0},
                                           {"_millimeter", 2.0},
                                           {"_CM", 20.0},
                                           {"_centimetre", 20.0},
                                           {"_m", 2000.0},
                                           {"_M", 2000.0},
                                           {"_meter", 2000.0},
                                           {"_Metre", 2000.0},
                                           {".m", 2000.0},
                                           {" (m)", 2000.0},
                                           {"[m]", 2000.0},
                                           {" / m", 2000.0},
                                           {"_inch", 50.8}}) {
    const auto row = second_row("t", place);
    ASSERT_TRUE(row) << place;
    EXPECT_NEAR(row->position.z(), millimetres, 1e-9) << place;
  }
  for (const auto& [time, seconds] :
       {std::pair{"Time", 2.0}, {"t_second", 2.0}, {"t_MS", 2e-3}, {"stamp.nanosec", 2e-9}, {"t [µs]", 2e-6}, {"t (microseconds)", 2e-6}}) {
    const auto row = second_row(time, "");
    ASSERT_TRUE(row) << time;
    EXPECT_NEAR(row->time, seconds, 1e-12) << time;
  }
}

TEST(MotionCsv, ALastWordThatIsNoKnownUnitIsRefusedUnlessTheUnitIsStated) {
  for (const char* place : {"_um", "_km", "_km2", "_foot", "_mile", "_x", ".x", " (px)", "[µm]", "_m (raw)"}) {
    EXPECT_FALSE(second_row("t_s", place)) << place;
    EXPECT_EQ(second_row("t_s", place, "", "cm").value().position.x(), 20.0) << place;
  }
  for (const char* time : {"t_min", "t_0", "header.stamp", "t (frames)"}) {
    EXPECT_FALSE(second_row(time, "_mm")) << time;
    EXPECT_EQ(second_row(time, "_mm", "ms").value().time, 2e-3) << time;
  }
}

TEST(MotionCsv, ForcesAreInNewtonsOrRefused) {
  const ScratchFolder folder;
  const auto force = [&](const std::string& name) {
    MotionColumns columns;
    columns.with_forces = true, columns.fz = name;
    const auto file = folder.write("forces.csv", "t_s,x_mm,y_mm,z_mm,fx_N,fy_N," + name + "\n0,0,0,0,0,0,0\n1,1,1,1,1,1,3\n");
    return read_motion_csv(file, columns)[1].force.z();
  };
  for (const char* name : {"fz", "z", "[z]", "fz_N", "force_z_n", "force.z", "wrench.force.z", "F_z", "F_N_z", "fz [Newton]"})
    EXPECT_EQ(force(name), 3.0) << name;
  for (const char* name : {"fz_mN", "fz_kN", "fz_lbf", "fz (V)", "F_mN_z", "F_mN_fz", "kN.z", "force [mN] z", "tip_fz"}) {
    EXPECT_THAT([&] { force(name); }, testing::ThrowsMessage<InputError>(HasSubstr("'" + std::string(name) + "' ends with '"))) << name;
  }
}

TEST(MotionCsv, ANameThatIsAnotherUnitIsRefusedUnlessTheUnitIsStated) {
  for (const char* time : {"ms", "ns", "microseconds"}) {
    EXPECT_FALSE(second_row(time, "_mm")) << time;
    EXPECT_EQ(second_row(time, "_mm", "ms").value().time, 2e-3) << time;
  }
  EXPECT_EQ(second_row("s", "_mm").value().time, 2.0);
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

/// /proc/self/mem opens, and cannot be read at its beginning.
TEST(MotionCsv, AFileThatCannotBeReadToItsEndIsNoShortOne) {
  EXPECT_THAT([] { (void)read_motion_csv("/proc/self/mem", {}); },
              testing::ThrowsMessage<InputError>(HasSubstr("cannot be read to its end")));
}

TEST(MotionCsv, EveryMalformedTableGetsItsSentence) {
  const std::string head = "t_s,x_mm,y_mm,z_mm\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", "is empty"},
      {head, "holds 0 rows"},
      {"\x89MCAP0\r\nrest", "is no text, but a table of times and positions is expected; export it as a table (CSV)"},
      {std::string("SQLite format 3\0rest", 20), "is no text"},
      {head + "0,1,2,3\n", "holds 1 rows"},
      {"t,x_mm,y_mm,z_mm\n0,0,0,0\n1,1,1,1\n", "line 1: no column is called 't_s', there are: t x_mm y_mm z_mm"},
      {"t_s,x_mm,y_mm,x_mm,z_mm\n0,0,0,0,0\n1,1,1,1,1\n", "line 1: two columns are called 'x_mm'"},
      {head + "0,1,2,3\n1,1,nan,3\n", "line 3: 'nan' in column 'y_mm' is not a finite number"},
      {head + "0,1,2,3\n1,inf,2,3\n", "line 3: 'inf' in column 'x_mm'"},
      {head + "0,1,2,3\n1,,2,3\n", "line 3: '' in column 'x_mm'"},
      {head + "0,1,2,3\n1,1.5abc,2,3\n", "line 3: '1.5abc' in column 'x_mm'"},
      {"t_s;x_mm;y_mm;z_mm\n0,0000;1,5;2;3\n1;1;2;3\n",
       "line 2: '0,0000' in column 't_s' has a decimal comma; save the table with decimal points"},
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
  const auto far = folder.write("far.csv", "t_s,x_m,y_m,z_m\n0,1,1,1\n1,1e306,1,1\n");
  EXPECT_THAT([&] { (void)read_motion_csv(far, parse_columns("x=x_m,y=y_m,z=z_m")); },
              testing::ThrowsMessage<InputError>(HasSubstr("far.csv: line 3: the place is farther away than a number can say")));
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
