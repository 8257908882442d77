/// `isotouch build`, and what reads its fields, in this process and on a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/cloud/ply.h"
#include "host/cloud/shapes.h"
#include "tests/host/commands/run_command.h"

namespace isotouch::commands {

/// The folder holds torus.ply, a scan of 400 points.
class Build : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("build_test_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    cloud::write_ply(folder_ / "torus.ply", cloud::sample_shape(cloud::shape("torus"), 400), "test");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  static std::string run(const std::string& arguments) { return run_command(arguments); }

 private:
  std::filesystem::path folder_;
};

}  // namespace isotouch::commands
