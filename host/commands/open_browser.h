/// Opens a page in the person's browser, where there is a screen for one.
#pragma once

#include <filesystem>
#include <string>

namespace isotouch::commands {

/// The address holds a token, and every user of a machine may read the arguments of programs. So the browser is given a file that only this user may
/// read and that leads on to the address.
class OpenedPage {
 public:
  /// Does nothing where there is no screen, or no xdg-open.
  explicit OpenedPage(const std::string& address);
  /// The file goes.
  ~OpenedPage();
  OpenedPage(const OpenedPage&) = delete;
  OpenedPage& operator=(const OpenedPage&) = delete;

 private:
  std::filesystem::path folder_;
};

}  // namespace isotouch::commands
