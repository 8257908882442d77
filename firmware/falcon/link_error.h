/// Why a link to a device did not do what it was asked to.
#pragma once

#include <cstdint>

#include "shared/result.h"

namespace isotouch::falcon {

enum class LinkError : std::uint8_t {
  kTimedOut,    ///< the device did not answer in time
  kGone,        ///< the device was unplugged, or the other end of the connection went away
  kStalled,     ///< the device refused a request
  kNotFound,    ///< no such device
  kNotAllowed,  ///< this user may not open the device
  kBusy,        ///< another program holds the device
  kUnsuitable,  ///< the device has the right name but not the expected endpoints, or its answer breaks the protocol
  kNoUsb,       ///< this machine offers no USB to programs
};

template <class T>
using LinkResult = Result<T, LinkError>;

/// The core of a sentence about a device; the caller adds which device.
constexpr const char* describe(LinkError error) {
  switch (error) {
    case LinkError::kTimedOut: return "it did not answer in time";
    case LinkError::kGone: return "it was unplugged or its connection was closed";
    case LinkError::kStalled: return "it refused a request";
    case LinkError::kNotFound: return "no such device is there";
    case LinkError::kNotAllowed: return "this user may not open it";
    case LinkError::kBusy: return "another program holds it";
    case LinkError::kUnsuitable: return "it answers, but not as this device should";
    case LinkError::kNoUsb: return "this machine offers no USB to programs";
  }
  return "unknown error";
}

}  // namespace isotouch::falcon
