/// The daemon's command line.
#pragma once

#include <cstdint>
#include <string>

#include "firmware/settings/settings.h"

namespace isotouch::daemon {

struct Options {
  enum class Device : std::uint8_t { kUsb, kSimulated, kRecorded };

  settings::Settings settings;  ///< the file's, changed by what the command line says
  Device device = Device::kUsb;
  std::string name;                ///< serial (may be empty), socket, or recording
  bool numbers_recordings = true;  ///< the recording takes the next free number; not so if the command line names its file
  bool lockstep = false;
  std::uint64_t ticks = UINT64_MAX;
};

/// Reads the command line, and the settings file that it names.
///
/// exit_code   when false is returned: everything that was asked for is done, or what was wrong has been said
bool read_options(int argc, char** argv, Options& options, int& exit_code);

}  // namespace isotouch::daemon
