/// Who is at the other end of a local socket, told by the kernel, and what they may do.
#pragma once

#include <sys/types.h>

#include <vector>

#include "shared/files/refusal.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

struct Peer {
  bool known = false;
  uid_t user = 0;
  std::vector<gid_t> groups;  ///< the primary one and the others
};

/// The peer of a connected local socket: as it was when it connected.
Peer peer_of(int socket);

struct Members {
  std::vector<uid_t> users;
  std::vector<gid_t> groups;
};

/// Who has which role. Root and the program's own user always have kService.
struct Admission {
  Members watch, operate, service;
};

/// The highest role of the peer; kNone: may not come in.
protocol::Role role_of(const Peer& peer, const Admission& admission);

/// Why somebody with the role kNone may not come in.
Refusal not_admitted(const Peer& peer);

}  // namespace isotouch::control
