/// Where a controller is, as written on the command line.
#pragma once

#include <string>
#include <vector>

namespace isotouch::link {

/// `unix:PATH`, or `ssh://[USER@]HOST[:PORT][/SOCKET]`.
struct Address {
  std::string text;    ///< as written, for sentences
  std::string socket;  ///< path of the control socket; over ssh it may be empty: the one that the controller's program knows
  std::string host;    ///< empty: this machine
  std::string user;    ///< empty: as ssh chooses
  std::string port;    ///< empty: as ssh chooses

  bool is_remote() const { return !host.empty(); }
};

/// fails     InputError: what is wrong with it and how one looks
Address read_address(const std::string& text);

/// Do both lead to one controller? On this machine that is seen, by whatever path; another one's is known by how it is written.
bool is_same_controller(const Address& a, const Address& b);

/// The program that runs a command on a remote machine, with its arguments. Nothing in an address is taken for an option, or for more than one word, on
/// either machine.
///
/// ssh       name or path of the program
/// there     for the shell of the other machine
std::vector<std::string> ssh_command(const Address& address, const std::string& ssh, const std::string& there);

/// What reaches the controller on its own machine: the relay. For ssh_command.
std::string relay_command(const Address& address);

}  // namespace isotouch::link
