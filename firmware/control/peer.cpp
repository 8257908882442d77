#include "firmware/control/peer.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace isotouch::control {

using protocol::Role;

namespace {

constexpr int kPeerGroups = 59;  // SO_PEERGROUPS, which the C library's headers may not have

template <class T>
bool holds(const std::vector<T>& all, T one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

bool has(const Members& members, const Peer& peer) {
  return holds(members.users, peer.user) ||
         std::any_of(peer.groups.begin(), peer.groups.end(), [&](gid_t group) { return holds(members.groups, group); });
}

}  // namespace

Peer peer_of(int socket) {
  Peer peer;
  ucred credentials{};
  socklen_t size = sizeof credentials;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &credentials, &size) != 0) return peer;
  peer.known = true;
  peer.user = credentials.uid;
  std::vector<gid_t> groups(64);
  for (int tries = 0; tries < 2; ++tries) {
    size = static_cast<socklen_t>(groups.size() * sizeof(gid_t));
    const bool done = ::getsockopt(socket, SOL_SOCKET, kPeerGroups, groups.data(), &size) == 0;
    const bool longer = !done && errno == ERANGE;
    groups.resize(done || longer ? size / sizeof(gid_t) : 0);
    if (!longer) break;
  }
  peer.groups = groups;
  peer.groups.push_back(credentials.gid);
  return peer;
}

Role role_of(const Peer& peer, const Admission& admission) {
  if (!peer.known) return Role::kNone;
  if (peer.user == 0 || peer.user == ::geteuid() || has(admission.service, peer)) return Role::kService;
  if (has(admission.operate, peer)) return Role::kOperate;
  return has(admission.watch, peer) ? Role::kWatch : Role::kNone;
}

Refusal not_admitted(const Peer& peer) {
  if (!peer.known) return "the system does not report who is connecting, so the connection is refused; use a local socket";
  return "user " + std::to_string(peer.user) +
         " may not use this controller; add the user, or a group of the user, to a role in its settings, [control]";
}

}  // namespace isotouch::control
