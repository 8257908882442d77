/// Who is at the other end of a local socket, told by the kernel, and whether they may come in.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "shared/files/refusal.h"

namespace isotouch::control {

struct Peer {
  bool known = false;
  uid_t user = 0;
  std::vector<gid_t> groups;  ///< the primary one and the others
};

/// Users and groups that may speak to this controller; root and the program's own user always may.
struct Admission {
  std::vector<uid_t> users;
  std::vector<gid_t> groups;
};

/// The peer of a connected local socket: as it was when it connected.
Peer peer_of(int socket);

/// returns   why this peer may not come in
Refusal refusal_of(const Peer& peer, const Admission& admission);

}  // namespace isotouch::control
