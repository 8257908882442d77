/// Who may read the page: whoever knows the address with its token, in a browser that came to this address itself.
///
/// Another user of this machine does not know the token. A foreign page in the same browser does not know it either, and is known by its Origin; one
/// that has its own name point to this machine is known by its Host.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isotouch::server {

/// 128 bits from the system's random numbers, as 32 hexadecimal digits.
///
/// fails     InputError when the system has none
std::string random_token();

/// What a request says of itself, as far as it decides who may read. The texts stay the caller's.
struct Asked {
  std::string_view target;         ///< path and query, as sent
  std::string_view host;           ///< header Host; empty: none
  std::string_view origin;         ///< header Origin; empty: none
  bool changes_something = false;  ///< a request that sends something, or opens the socket: a browser always names its origin there
};

/// What a request gets.
struct Admission {
  unsigned status = 200;      ///< of HTTP; 200: let in
  std::string_view sentence;  ///< why not, and what to do
  std::string_view path;      ///< of the target, behind the token: "page.js"; points into it
  std::string_view query;     ///< behind the question mark, may be empty

  bool granted() const { return status == 200; }
};

/// Thread-safe: it never changes.
class AccessCheck {
 public:
  /// port      of 127.0.0.1 that is served
  /// token     the first part of every path: `random_token`
  AccessCheck(std::uint16_t port, std::string token);

  /// What to open in a browser, with the token and a slash behind it.
  std::string address() const { return origin_ + "/" + token_ + "/"; }
  /// Where the page's socket is, without the path: a list of sources for the page's policy, with a space between them.
  std::string socket_origin() const;

  /// Judges one request, in constant time for tokens of one length.
  ///
  /// returns   status 200, 403 for a foreign host, origin or token, or 404 for an address without its slash; never fails
  Admission admit(const Asked& asked) const;

 private:
  bool is_here(std::string_view host) const { return host == here_ || host == named_; }

  std::string token_, here_, named_, origin_;
};

}  // namespace isotouch::server
