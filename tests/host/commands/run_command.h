/// The tool's commands in the test's own process.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/commands/commands.h"
#include "host/error.h"

namespace isotouch::commands {

/// What `isotouch` with these arguments, separated by spaces, prints on standard output. Lets pass what it throws.
inline std::string run_command(const std::string& arguments) {
  CLI::App app;
  for (const auto add : {add_build, add_info, add_export, add_sample, add_compare, add_scan, add_trace, add_render, add_plot, add_demo})
    add(app);
  ::testing::internal::CaptureStdout();
  try {
    app.parse(arguments);
  } catch (...) {
    ::testing::internal::GetCapturedStdout();
    throw;
  }
  return ::testing::internal::GetCapturedStdout();
}

/// The sentence with which it refuses; empty when it does not.
inline std::string complaint_on(const std::string& arguments) {
  try {
    run_command(arguments);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace isotouch::commands
