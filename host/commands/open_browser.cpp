#include "host/commands/open_browser.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <system_error>

namespace isotouch::commands {

namespace {

bool has_screen() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

/// Runs it as nobody's child: what the browser says and how long it runs is its own affair.
void start(const char* program, const char* argument) {
  const pid_t child = ::fork();
  if (child > 0) ::waitpid(child, nullptr, 0);
  if (child != 0) return;
  ::setsid();
  if (::fork() != 0) ::_exit(0);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  ::execlp(program, program, argument, static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

OpenedPage::OpenedPage(const std::string& address) {
  if (!has_screen()) return;
  std::string folder = (std::filesystem::temp_directory_path() / "isotouch-view-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return;  // the address was printed
  folder_ = folder;
  const std::string page = folder + "/open.html";
  std::ofstream(page) << "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0;url=" << address
                      << "\"><title>isotouch</title>\n";
  start("xdg-open", page.c_str());
}

OpenedPage::~OpenedPage() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

}  // namespace isotouch::commands
