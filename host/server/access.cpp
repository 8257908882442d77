#include "host/server/access.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "host/error.h"

namespace isotouch::server {

namespace {

constexpr std::string_view kScheme = "http://";

/// Takes as long for every text of one length: how long it took tells nothing of where they differ.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InputError("the system gives no random numbers, so the page cannot be protected; start again in a moment");
  std::string token;
  for (const unsigned char byte : bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    token += kDigits[byte >> 4];
    token += kDigits[byte & 15];
  }
  return token;
}

AccessCheck::AccessCheck(std::uint16_t port, std::string token)
    : token_(std::move(token)),
      here_("127.0.0.1:" + std::to_string(port)),
      named_("localhost:" + std::to_string(port)),
      origin_(std::string(kScheme) + here_) {}

std::string AccessCheck::socket_origin() const { return "ws://" + here_ + " ws://" + named_; }

Admission AccessCheck::admit(const Asked& asked) const {
  if (!is_here(asked.host))
    return {403, "This server answers to 127.0.0.1 and localhost only; open the address that isotouch view has printed.", {}, {}};
  const bool same_origin = asked.origin.starts_with(kScheme) && asked.origin.substr(kScheme.size()) == asked.host;
  if (asked.origin.empty() ? asked.changes_something : !same_origin)
    return {403, "Another page asked for this; open the address that isotouch view has printed.", {}, {}};
  const std::string_view target = asked.target;
  const std::size_t end = std::min(target.find('/', 1), target.size());
  if (!target.starts_with('/') || !same(target.substr(1, end - 1), token_))
    return {403, "The token in this address is wrong; open the address that isotouch view has printed.", {}, {}};
  if (end == target.size()) return {404, "The address ends with a slash; open it as isotouch view has printed it.", {}, {}};
  const std::size_t question = std::min(target.find('?', end), target.size());
  return {200, {}, target.substr(end + 1, question - end - 1), target.substr(std::min(question + 1, target.size()))};
}

}  // namespace isotouch::server
