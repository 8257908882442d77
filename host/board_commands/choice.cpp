#include "host/board_commands/choice.h"

#include <algorithm>
#include <utility>

#include "shared/files/nearest_name.h"

namespace isotouch::commands {

CLI::Validator one_of(std::vector<std::string> names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
  const auto check = [names = std::move(names), list](std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return {};
    const std::string meant = files::nearest_name(text, names);
    return "there is no '" + text + "'; " + (meant.empty() ? "" : "did you mean '" + meant + "'? ") + "the choices are " + list;
  };
  return {check, "one of " + list, "one of"};
}

}  // namespace isotouch::commands
