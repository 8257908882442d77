#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/cloud/file_kind.h"
#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "host/error.h"
#include "tests/host/commands/build_fixture.h"
#include "tests/support/no_more_threads.h"

namespace isotouch::commands {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::string> keys(const nlohmann::ordered_json& json) {
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  return names;
}

TEST_F(Build, TheReportHasTheKeysThatScriptsRelyOn) {
  const auto json = nlohmann::ordered_json::parse(run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 40 --json"));
  EXPECT_EQ(json["points"], 400);
  EXPECT_LT(3 * fs::file_size(file("t.itf")), 2 * json["bytes"].get<std::size_t>()) << "the file is packed";
  EXPECT_EQ(json["hash"].get<std::string>().size(), 16U);
  EXPECT_GT(json["stages"].size(), 2U);
  double sum = 0;
  for (const auto& [stage, seconds] : json["stages"].items()) sum += seconds.get<double>();
  EXPECT_NEAR(json["seconds"].get<double>(), sum, 1e-9);
  const double radii = 40.0 / 190;  // a torus of 70 and 25: 190 across
  const double volume = 2 * M_PI * M_PI * 70 * 25 * 25 * radii * radii * radii;
  EXPECT_NEAR(json["inside_nodes"].get<double>(), volume, 0.05 * volume);

  const auto info = nlohmann::ordered_json::parse(run("info " + file("t.itf") + " --json"));
  EXPECT_EQ(keys(info), (std::vector<std::string>{"bytes", "voxel_mm", "grid", "band_voxels", "interpolation", "bricks", "hash", "version",
                                                  "wire_bytes", "dense_float_bytes", "certificate", "stiffness_n_per_mm"}));
  EXPECT_EQ(info["interpolation"], "spline");
  EXPECT_EQ(info["hash"], json["hash"]);
  EXPECT_EQ(info["bytes"], json["bytes"]);
  EXPECT_EQ(info["wire_bytes"], fs::file_size(file("t.itf")));
  EXPECT_EQ(json["wire_bytes"], info["wire_bytes"]);
  std::size_t dense = sizeof(float);
  for (const auto& along : info["grid"]) dense *= along.get<std::size_t>();
  EXPECT_EQ(info["dense_float_bytes"], dense);
  EXPECT_EQ(json["dense_float_bytes"], dense);
  EXPECT_EQ(info["version"], "1.1");
  EXPECT_EQ(info["grid"].size(), 3U);
  EXPECT_NEAR(info["voxel_mm"].get<double>(), 70.0 / 40, 0.05);
}

TEST_F(Build, ATrilinearFieldSaysSo) {
  run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 40 --interpolation trilinear");
  const auto info = nlohmann::ordered_json::parse(run("info " + file("t.itf") + " --json"));
  EXPECT_EQ(info["interpolation"], "trilinear");
  EXPECT_EQ(info["version"], "1.3");
}

TEST_F(Build, TheExportedImageIsTheSameField) {
  const auto json = nlohmann::json::parse(run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 30 --json"));
  run("export " + file("t.itf") + " -o " + file("t.itfi"));
  EXPECT_EQ(json["bytes"], fs::file_size(file("t.itfi")));
  EXPECT_EQ(run("info " + file("t.itf") + " --json"), run("info " + file("t.itfi") + " --json"));
  run("export " + file("t.itfi") + " -o " + file("again.itf"));
  EXPECT_EQ(fs::file_size(file("again.itf")), fs::file_size(file("t.itf")));
  EXPECT_EQ(json["hash"], nlohmann::json::parse(run("info " + file("t.itfi") + " --json"))["hash"]);
}

TEST_F(Build, AnExportWithoutAKnownExtensionIsRefusedBeforeTheFieldIsRead) {
  for (const char* name : {"t", "t.itfx", "t.xyz"}) {
    try {
      run("export " + file("missing.itf") + " -o " + file(name));
      FAIL() << name;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr(".itfi (a field's image")) << name;
    }
  }
  EXPECT_THROW(run("export " + file("missing.itf") + " -o " + file("t.itfi")), InputError);
}

TEST_F(Build, TheSameCloudGivesTheSameHash) {
  const std::string arguments = "build " + file("torus.ply") + " --grid 30 --json -o ";
  const auto first = nlohmann::json::parse(run(arguments + file("a.itf")));
  const auto second = nlohmann::json::parse(run(arguments + file("b.itf")));
  EXPECT_EQ(first["hash"], second["hash"]);
  const auto other = nlohmann::json::parse(run(arguments + file("c.itf") + " --band 4"));
  EXPECT_NE(first["hash"], other["hash"]);
}

TEST_F(Build, TheSameHashIsMadeWithoutMoreThreads) {
  const auto hash = [&](const std::string& made) {
    return nlohmann::json::parse(run("build " + file("torus.ply") + " -o " + file(made) + " --threads 4 --json"))["hash"]
        .get<std::string>();
  };
  const std::string with = hash("with.itf");
  const test::NoMoreThreads none;
  EXPECT_EQ(hash("without.itf"), with);
}

TEST_F(Build, ThePublishedMethodMakesAFieldOfItsOwn) {
  const auto json =
      nlohmann::ordered_json::parse(run("build " + file("torus.ply") + " -o " + file("p.itf") + " --method published --grid 30 --json"));
  EXPECT_EQ(keys(json["stages"]), (std::vector<std::string>{"read", "outside", "radii", "indicator", "levels", "image", "pack", "write"}));
  EXPECT_GT(json["inside_nodes"], 1000);
  EXPECT_THAT(run("info " + file("p.itf")), HasSubstr("published, from 400 points"));
  const auto info = nlohmann::json::parse(run("info " + file("p.itf") + " --json"));
  EXPECT_EQ(info["band_voxels"], 7.0);
  EXPECT_EQ(info["interpolation"], "trilinear");
}

TEST_F(Build, SizeIsTrueWithUnitsAndMadeToFitWithout) {
  run("build " + file("torus.ply") + " -o " + file("u.itf") + " --units mm --voxel 4mm");
  const auto true_size = nlohmann::json::parse(run("info " + file("u.itf") + " --json"));
  EXPECT_EQ(true_size["voxel_mm"], 4.0);
  EXPECT_GT(true_size["grid"][0], 190 / 4);
  run("build " + file("torus.ply") + " -o " + file("u.itf") + " --fit 4cm --voxel 1mm");
  const auto fitted = nlohmann::json::parse(run("info " + file("u.itf") + " --json"));
  EXPECT_GT(fitted["grid"][0], 40);
  EXPECT_LT(fitted["grid"][0], 40 + 30);
}

TEST_F(Build, AMeshGetsTheFineGridAndASparseScanTheCoarseOne) {
  std::ofstream(file("cube.obj")) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                     "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const auto grid_of = [this](const std::string& input) {
    run("build " + file(input) + " -o " + file("g.itf"));
    run("export " + file("g.itf") + " -o " + file("g.itfi"));
    return nlohmann::json::parse(run("info " + file("g.itf") + " --json"))["grid"][0].get<int>();
  };
  EXPECT_GT(grid_of("cube.obj"), 290);
  EXPECT_LT(std::filesystem::file_size(file("g.itfi")), 16U << 20);
  EXPECT_GT(grid_of("torus.ply"), 186);
  EXPECT_LT(grid_of("torus.ply"), 186 + 30);
}

TEST_F(Build, WhatIsTooSmallForTheGridIsCounted) {
  std::string faces, vertices;
  int first = 1;
  for (const auto& [at, edge] : {std::pair{0, 10}, {14, 1}}) {
    for (int n = 0; n < 8; ++n) {
      const auto side = [&, at = at, edge = edge](int bit) { return std::to_string(at + ((n >> bit & 1) != 0 ? edge : 0)) + ' '; };
      vertices += "v " + side(0) + side(1) + side(2) + '\n';
    }
    for (const auto& face : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      faces += "f";
      for (const int corner : face) faces += ' ' + std::to_string(first + corner);
      faces += '\n';
    }
    first += 8;
  }
  std::ofstream(file("two.obj")) << vertices << faces;
  const auto warnings_of = [this](const std::string& voxel) {
    return nlohmann::json::parse(
               run("build " + file("two.obj") + " -o " + file("t.itf") + " --units mm --json --voxel " + voxel))["warnings"]
        .dump();
  };
  EXPECT_THAT(warnings_of("0.7mm"), HasSubstr("1 piece of surface too small for the grid left out"));
  EXPECT_EQ(warnings_of("0.2mm"), "[]");
}

TEST_F(Build, AGridFinerThanTheScanSupportsIsToldWithTheOneThatShowsAsMuch) {
  const auto warnings_of = [this](const std::string& options) {
    const auto json = nlohmann::json::parse(run("build " + file("torus.ply") + options + " --json -o " + file("g.itf")));
    return json["warnings"].get<std::vector<std::string>>();
  };
  EXPECT_THAT(warnings_of(" --grid 200"), ::testing::Contains(HasSubstr("finer than the scan supports")));
  EXPECT_THAT(warnings_of(" --voxel 0.4mm"), ::testing::Contains(HasSubstr("--grid ")));
  EXPECT_THAT(warnings_of(" --grid 40"), ::testing::Not(::testing::Contains(HasSubstr("supports"))));
  EXPECT_THAT(warnings_of(""), ::testing::Not(::testing::Contains(HasSubstr("supports"))));
}

TEST_F(Build, WrongUsageIsToldBeforeAnythingIsRead) {
  const std::string start = "build " + file("missing.ply") + " -o " + file("x.itf");
  for (const char* wrong : {"--voxel 0.5kg", "--voxel 0.5mm --grid 20", "--grid 12.5", "--band 9", "--stiffness nan", "--units mm --fit 70",
                            "--units ft", "--method magic", "--method published --band 4", "--method published --interpolation spline"}) {
    EXPECT_THROW(run(start + " " + wrong), CLI::ParseError) << wrong;
  }
  EXPECT_THROW(run(start), InputError);
}

/// `build` of a mesh, then `compare --floor`: what the mesh's field and its own exact distances differ from it.
void expect_floor(const nlohmann::json& compared) {
  ASSERT_GT(compared["rms_voxel"].get<double>(), 0);
  for (const char* key : {"rms_mm", "rms_voxel", "p99_voxel", "max_voxel", "normal_rms_deg", "lost"}) {
    EXPECT_EQ(compared[key], compared["floor"][key]) << key;
  }
}

void write_box(const fs::path& path) {
  std::ofstream(path) << "v 0 0 0\nv 3 0 0\nv 0 2 0\nv 3 2 0\nv 0 0 1\nv 3 0 1\nv 0 2 1\nv 3 2 1\n"
                         "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

TEST_F(Build, AMeshComesBackAsExactAsItsGridCanHold) {
  write_box(file("box.obj"));
  const auto json = nlohmann::ordered_json::parse(run("build " + file("box.obj") + " -o " + file("m.itf") + " --grid 60 --json"));
  EXPECT_EQ(json["input"], "mesh");
  EXPECT_EQ(json["points"], 8);
  EXPECT_EQ(json["warnings"].size(), 0U);
  EXPECT_EQ(keys(json["stages"]), (std::vector<std::string>{"read", "check", "tree", "bricks", "image", "pack", "write"}));
  const double volume = 60.0 * 40 * 20;
  EXPECT_NEAR(json["inside_nodes"].get<double>(), volume, 0.08 * volume);
  expect_floor(nlohmann::json::parse(run("compare " + file("m.itf") + " " + file("box.obj") + " --floor --json")));
}

TEST_F(Build, AnotherMeshIsInterpolatedAsTheField) {
  write_box(file("box.obj"));
  for (const char* interpolation : {"spline", "trilinear"}) {
    run("build " + file("box.obj") + " -o " + file("m.itf") + " --grid 24 --interpolation " + interpolation);
    const auto json =
        nlohmann::json::parse(run("compare " + file("m.itf") + " " + file("box.obj") + " --beside " + file("box.obj") + " --json"));
    for (const char* key : {"rms_voxel", "p99_voxel", "normal_rms_deg"}) EXPECT_EQ(json["beside"][key], json[key]) << key;
  }
}

TEST_F(Build, ARealMeshComesBackAsExactAsItsGridCanHold) {
  const char* data = std::getenv("ISOTOUCH_DATA");
  if (data == nullptr) GTEST_SKIP() << "ISOTOUCH_DATA names no folder";
  const std::string mesh = (fs::path(data) / "meshes" / "goathead.ply").string();
  run("build " + mesh + " -o " + file("m.itf") + " --grid 100");
  expect_floor(nlohmann::json::parse(run("compare " + file("m.itf") + " " + mesh + " --floor --json")));
}

TEST_F(Build, WhatAFileIsTakenForCanBeSaid) {
  std::ofstream(file("tetra.obj")) << "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  EXPECT_THROW(run("build " + file("tetra.obj") + " -o " + file("t.itf") + " --as cloud"), InputError);
  EXPECT_THROW(run("build " + file("tetra.obj") + " -o " + file("t.itf") + " --method published"), InputError);
  EXPECT_THROW(run("build " + file("torus.ply") + " -o " + file("t.itf") + " --as mesh"), InputError);
  EXPECT_THROW(run("build " + file("tetra.obj") + " -o " + file("t.itf") + " --as soup"), CLI::ParseError);
  run("build " + file("tetra.obj") + " -o " + file("t.itf") + " --as mesh --grid 20");
}

/// As modelling programs export it: few large faces, and a normal at each corner.
TEST_F(Build, FacesThatAreNotUsedAreNamed) {
  std::string cube = "ply\nformat ascii 1.0\nelement vertex 8\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) cube += std::string("property float ") + name + '\n';
  cube += "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  for (int corner = 0; corner < 8; ++corner) {
    for (const char* length : {"1", "0.577"}) {
      for (int axis = 0; axis < 3; ++axis) cube += std::string((corner >> axis & 1) != 0 ? "" : "-") + length + ' ';
    }
    cube += '\n';
  }
  const std::string five = "4 0 4 6 2\n4 1 3 7 5\n4 0 1 5 4\n4 2 6 7 3\n4 0 2 3 1\n";
  std::ofstream(file("cube.ply")) << cube << five << "4 4 5 7 6\n";
  std::string open = cube + five;
  std::ofstream(file("open.ply")) << open.replace(open.find("face 6"), 6, "face 5");
  const std::string options = " --grid 20 -o " + file("c.itf");
  const std::string better = "its 6 faces form a closed surface and were not used; take them with --as mesh; ";
  EXPECT_THAT(complaint_on("build " + file("cube.ply") + options), HasSubstr("cube.ply: the field would probably be wrong: " + better));
  EXPECT_THAT(complaint_on("build " + file("cube.ply") + " --normals estimate" + options), HasSubstr(better));
  EXPECT_THAT(complaint_on("build " + file("open.ply") + options),
              ::testing::AllOf(Not(::testing::IsEmpty()), ::testing::Not(HasSubstr("as mesh"))));
  const auto json = nlohmann::ordered_json::parse(run("build " + file("open.ply") + " --accept-implausible --json" + options));
  EXPECT_EQ(json["warnings"][0], "its 5 faces were not used; --as mesh takes them");
  EXPECT_NO_THROW(run("build " + file("cube.ply") + " --as mesh" + options));
}

TEST_F(Build, AnEndingThatIsNotWrittenIsRefused) {
  for (const char* name : {"t.vdb", "t.ply", "t.JPG"}) {
    try {
      run("build " + file("torus.ply") + " -o " + file(name) + " --grid 40");
      FAIL() << name;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("isotouch export"));
    }
    EXPECT_FALSE(fs::exists(file(name)));
  }
}

TEST_F(Build, WarnsOfWhatTheDeviceCannotReachAndAControllerCannotHold) {
  const auto small = nlohmann::json::parse(run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 40 --json"));
  EXPECT_EQ(small["warnings"].size(), 0U) << small["warnings"].dump();
  const auto large = nlohmann::json::parse(run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 800 --fit 130mm --json"));
  EXPECT_THAT(large["warnings"].dump(), HasSubstr("extends 65 mm"));
  EXPECT_THAT(large["warnings"].dump(), HasSubstr("keeps 16 MiB"));
}

TEST_F(Build, SampleAnswersAsTheFieldDoes) {
  run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 60");
  std::ofstream(file("places.csv")) << "x,y,z\n25.789,0,0\n0,0,0\n100,0,0\n";
  std::istringstream lines(run("sample " + file("t.itf") + " " + file("places.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "x_mm,y_mm,z_mm,distance_mm,gradient_x,gradient_y,gradient_z,stiffness_n_mm,in_band");
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
    ASSERT_EQ(rows.back().size(), 9U);
  }
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_LT(rows[0][3], 0) << "in the tube";
  EXPECT_GT(rows[1][3], 0) << "in the hole of the ring";
  EXPECT_EQ(rows[2][8], 0) << "far outside";
  EXPECT_NEAR(rows[0][7], 0.8, 1e-4);
  // In the scan's frame: a point of the torus lies on the surface.
  std::ofstream(file("own.csv")) << "95,0,0\n";
  const std::string own = run("sample " + file("t.itf") + " " + file("own.csv") + " --input-frame");
  std::istringstream answer(own.substr(own.find('\n') + 1));
  double x = 0, y = 0, z = 0, distance = 9;
  char comma = 0;
  answer >> x >> comma >> y >> comma >> z >> comma >> distance;
  EXPECT_NEAR(x, 35, 0.5);
  EXPECT_NEAR(distance, 0, 0.3);
  EXPECT_THROW(run("sample " + file("t.itf") + " " + file("own.csv") + " -o " + file("x.vdb")), InputError);
}

/// A text of places is read as a text of points is, but only its positions are.
TEST_F(Build, SampleReadsItsPlacesAsBuildDoes) {
  run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 20");
  const auto first_row = [&](const std::string& places) {
    std::ofstream(file("places.csv")) << places;
    const std::string table = run("sample " + file("t.itf") + " " + file("places.csv"));
    return table.substr(table.find('\n') + 1, 6);
  };
  EXPECT_EQ(first_row("id,x,y,z\n7,1,2,3\n"), "1.0,2.");
  EXPECT_EQ(first_row("z,y,x\n3,2,1\n"), "1.0,2.");
  EXPECT_EQ(first_row("x_mm,y_mm,z_mm,distance_mm\n1,2,3,9\n"), "1.0,2.") << "as it writes them";
  EXPECT_EQ(first_row("1 2 3 0 0 1\n"), "1.0,2.");
  EXPECT_EQ(first_row("1,2,3,10,20,30\n"), "1.0,2.") << "with colours";
  EXPECT_EQ(first_row("1 2 3 7\n"), "1.0,2.");
  for (const char* refused : {"1,5;2,5;3,5\n", "1.0o 2 3\n4 5 6\n", "x,y,z\n,1,2,3\n", "1 nan 3\n", "1 2\n"})
    EXPECT_THROW(first_row(refused), InputError) << refused;
}

TEST_F(Build, BadInputLeavesTheOldFile) {
  run("build " + file("torus.ply") + " -o " + file("t.itf") + " --grid 20");
  const auto before = nlohmann::json::parse(run("info " + file("t.itf") + " --json"));
  std::ofstream(file("bad.xyz")) << "0 0 0 0 0 nan\n";
  EXPECT_THROW(run("build " + file("bad.xyz") + " -o " + file("t.itf")), InputError);
  EXPECT_EQ(nlohmann::json::parse(run("info " + file("t.itf") + " --json")), before);
}

TEST_F(Build, TheDocumentListsTheEndingsOfText) {
  std::ifstream page(fs::path(ISOTOUCH_GOLDEN) / "../../docs/build-a-field.md");
  std::string row;
  while (std::getline(page, row) && !row.starts_with("| text: ")) {
  }
  std::erase(row, '`');
  const std::string begin = "| text: " + cloud::endings_of(cloud::FileKind::kText) + " | points |";
  EXPECT_EQ(row.substr(0, begin.size()), begin);
}

TEST_F(Build, InfoSaysWhichFileIsNoFieldAndWhy) {
  try {
    run("info " + file("torus.ply"));
    FAIL() << "a cloud was taken for a field";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("torus.ply"));
    EXPECT_THAT(e.what(), HasSubstr(": is no field; make one of a scan or a mesh with isotouch build"));
  }
}

TEST_F(Build, TheStiffnessOfThePointsReachesTheField) {
  cloud::OrientedPoints points = cloud::sample_shape(cloud::shape("torus"), 400);
  for (const auto& p : points.positions) points.stiffness.push_back(p.x() < 0 ? 0.4 : 1.2);
  cloud::write_ply(file("soft.ply"), points, "test");
  for (const std::string method : {"default", "published"}) {
    run("build " + file("soft.ply") + " -o " + file("s.itf") + " --grid 40 --method " + method);
    const auto info = nlohmann::ordered_json::parse(run("info " + file("s.itf") + " --json"));
    EXPECT_EQ(info["version"], method == "published" ? "1.3" : "1.2");
    EXPECT_NEAR(info["stiffness_n_per_mm"]["least"].get<double>(), 0.4, 0.004) << method;
    EXPECT_NEAR(info["stiffness_n_per_mm"]["largest"].get<double>(), 1.2, 0.0001) << method;
    run("build " + file("soft.ply") + " -o " + file("s.itf") + " --grid 40 --stiffness 0.6 --method " + method);
    const auto scaled = nlohmann::ordered_json::parse(run("info " + file("s.itf") + " --json"));
    EXPECT_NEAR(scaled["stiffness_n_per_mm"]["least"].get<double>(), 0.2, 0.002) << method;
    EXPECT_NEAR(scaled["stiffness_n_per_mm"]["largest"].get<double>(), 0.6, 0.0001) << method;
  }
}

}  // namespace
}  // namespace isotouch::commands
