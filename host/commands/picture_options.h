/// Options that every picture has: its file, its size, where the eye is.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/board_commands/number_in.h"
#include "host/board_commands/number_list.h"
#include "host/board_commands/output.h"
#include "host/view/camera.h"

namespace isotouch::commands {

struct PictureOptions {
  std::filesystem::path out;
  std::array<int, 2> size = {960, 720};  ///< width, height
  std::vector<double> view;              ///< azimuth, elevation; empty: chosen
  char up = 'y';

  void add_to(CLI::App& command) {
    add_output(command, "-o,--out", out, kPictures, "the picture to write")->required();
    command.add_option_function<std::string>(
        "--size", [this](const std::string& text) { size = parse_size(text); }, "WxH, pixels (960x720)");
  }
  /// For pictures in perspective.
  void add_view_to(CLI::App& command) {
    take_numbers(command.add_option("--view", view, "where the eye is, degrees; 0,0 is in front (35,20)"), "AZIMUTH,ELEVATION")
        ->check(number_in(-360.0, 360.0));
    command.add_option("--up", up, "the axis that points upwards: x, y or z")->check(CLI::IsMember({"x", "y", "z"}))->capture_default_str();
  }
  std::optional<view::Direction> direction() const {
    if (view.empty()) return std::nullopt;
    return view::Direction{view[0], view[1], up};
  }

 private:
  static std::array<int, 2> parse_size(const std::string& text) {
    std::array<int, 2> parsed{};
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &parsed[0], &parsed[1], &rest) != 2)
      throw CLI::ValidationError("--size", "must be WxH, such as 960x720");
    for (const int side : parsed) {
      if (side < 320 || side > 8192) throw CLI::ValidationError("--size", "each side is 320 to 8192 pixels");
    }
    return parsed;
  }
};

/// A sub-command that draws: its options live as long as the parser.
///
/// Run       has `PictureOptions picture`, and draws when it is called
template <class Run>
std::pair<CLI::App*, Run*> add_picture(CLI::App& parent, const char* name, const char* about) {
  auto run = std::make_shared<Run>();
  CLI::App* command = parent.add_subcommand(name, about);
  run->picture.add_to(*command);
  command->callback([run] { (*run)(); });
  return {command, run.get()};
}

}  // namespace isotouch::commands
