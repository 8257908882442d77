#include "host/link/address.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "host/error.h"

namespace isotouch::link {

namespace {

constexpr std::string_view kUnix = "unix:", kSsh = "ssh://";

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
  throw UsageError(text + ": " + what + "; write unix:PATH or ssh://user@host[:port][/path of the socket]");
}

bool is_plain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.' || c == ':' || c == '%';
}

/// A name that no program takes for an option or for something else.
bool is_name(const std::string& name) { return !name.empty() && name[0] != '-' && std::all_of(name.begin(), name.end(), is_plain); }

/// One word for the shell of the other machine.
std::string quoted(const std::string& word) {
  std::string text(1, '\'');
  for (const char c : word) c == '\'' ? text.append("'\\''") : text.append(1, c);
  return text.append(1, '\'');
}

}  // namespace

Address read_address(const std::string& text) {
  Address address;
  address.text = text;
  if (text.starts_with(kUnix)) {
    address.socket = text.substr(kUnix.size());
    if (address.socket.empty()) refuse(text, "names no socket");
    return address;
  }
  if (!text.starts_with(kSsh)) refuse(text, "is no address of a controller");
  std::string rest = text.substr(kSsh.size());
  if (const auto slash = rest.find('/'); slash != std::string::npos) {
    address.socket = rest.substr(slash);
    rest.resize(slash);
    if (address.socket == "/") address.socket.clear();
  }
  if (const auto at = rest.find('@'); at != std::string::npos) {
    address.user = rest.substr(0, at);
    rest = rest.substr(at + 1);
    if (!is_name(address.user)) refuse(text, "has a user name that cannot be one");
  }
  const auto bracket = rest.starts_with('[') ? rest.find(']') : 0;
  if (bracket == std::string::npos) refuse(text, "has an opening bracket without a closing one");
  if (const auto colon = rest.find(':', bracket); colon != std::string::npos) {
    address.port = rest.substr(colon + 1);
    rest.resize(colon);
    const bool digits = std::all_of(address.port.begin(), address.port.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!digits || address.port.empty() || address.port.size() > 5 || std::stoi(address.port) == 0 || std::stoi(address.port) > 65535) {
      refuse(text, "has a port that is none from 1 to 65535");
    }
  }
  if (bracket > 0) rest = rest.substr(1, rest.size() - 2);
  if (!is_name(rest)) refuse(text, "has a host name that cannot be one");
  address.host = rest;
  return address;
}

bool is_same_controller(const Address& a, const Address& b) {
  if (a.is_remote() || b.is_remote()) return a.text == b.text;
  struct stat one {
  }, other{};
  return ::stat(a.socket.c_str(), &one) == 0 && ::stat(b.socket.c_str(), &other) == 0 && one.st_dev == other.st_dev &&
         one.st_ino == other.st_ino;
}

std::vector<std::string> ssh_command(const Address& address, const std::string& ssh, const std::string& there) {
  std::vector<std::string> command = {ssh, "-T"};
  if (!address.port.empty()) command.insert(command.end(), {"-p", address.port});
  if (!address.user.empty()) command.insert(command.end(), {"-l", address.user});
  command.insert(command.end(), {"--", address.host, there});
  return command;
}

std::string relay_command(const Address& address) {
  return address.socket.empty() ? "isotouchd relay" : "isotouchd relay " + quoted(address.socket);
}

}  // namespace isotouch::link
