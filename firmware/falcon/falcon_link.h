/// The seam to a Falcon: control requests, bytes out, bytes in. Over USB it is `falcon_usb.h`, over a local socket `sim_link.h`, in tests a script.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "firmware/falcon/link_error.h"

namespace isotouch::falcon {

inline constexpr std::uint16_t kFalconVendor = 0x0403;
inline constexpr std::uint16_t kFalconProduct = 0xCB48;
/// What may be read at once comes in packets of this size; a buffer that is no multiple of it can overflow.
inline constexpr std::size_t kUsbPacket = 64;

/// The eight setup bytes of a USB control request.
using UsbSetup = std::array<std::uint8_t, 8>;

/// What a device says of itself; known while the link is open.
struct FalconIdentity {
  std::uint16_t vendor = 0, product = 0, release = 0;
  std::string manufacturer, name, serial;
};

/// One Falcon, used by one thread. After kGone nothing works until `close` and `open`.
class FalconLink {
 public:
  virtual ~FalconLink() = default;

  /// Finds the device and takes it. Allocates; takes up to seconds.
  ///
  /// fails     kNotFound, kNotAllowed, kBusy, kNoUsb, kUnsuitable, kGone
  virtual LinkResult<void> open() = 0;

  /// Gives the device back; nothing is pending afterwards. A closed link may be closed again.
  virtual void close() = 0;

  virtual bool is_open() const = 0;
  virtual const FalconIdentity& identity() const = 0;

  /// A control request without a data stage from the host; with wLength 0 and an empty `answer`, or as long as the `answer` in bytes 6 and 7.
  ///
  /// returns   bytes of the answer, at most its size
  /// fails     kStalled: the device does not know the request; kGone; kTimedOut
  virtual LinkResult<std::size_t> control(const UsbSetup& setup, std::span<std::uint8_t> answer) = 0;

  /// Hands bytes to the device, endpoint 0x02. They may still be on their way when it returns.
  ///
  /// data      1 to 4096 bytes
  /// returns   bytes taken, from the front; may be fewer than given
  /// fails     kTimedOut: nothing was taken; kStalled; kGone
  virtual LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t timeout_ms) = 0;

  /// Waits for bytes of endpoint 0x81 as the FT232R frames them: every 64 bytes begin with two status bytes, and only the last 64 may be fewer.
  ///
  /// buffer      a multiple of 64 bytes
  /// timeout_ms  0: what is there already
  /// returns     at least 2, often just the status pair
  /// fails       kTimedOut; kStalled; kGone
  virtual LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) = 0;
};

/// What a person can do about an error of a link: half a sentence to follow `describe`.
const char* advice(LinkError error);

}  // namespace isotouch::falcon
