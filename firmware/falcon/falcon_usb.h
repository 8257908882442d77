/// The link to a real Falcon, over libusb.
///
/// Several IN transfers are always pending, so that neither the chip's empty packets nor a reply in pieces cost a USB frame; OUT transfers are only
/// handed over. libusb allocates on every submission: the link belongs to a thread of its own, never to the tick's.
#pragma once

#include <memory>
#include <string>

#include "firmware/falcon/falcon_link.h"
#include "firmware/loop/clock.h"

namespace isotouch::falcon {

class FalconUsb final : public FalconLink {
 public:
  /// clock     lives longer
  /// serial    which one; empty: the first that can be opened
  explicit FalconUsb(loop::Clock& clock, std::string serial = {});
  ~FalconUsb() override;
  FalconUsb(const FalconUsb&) = delete;
  FalconUsb& operator=(const FalconUsb&) = delete;

  LinkResult<void> open() override;
  /// Lets what was written go out, cancels the rest, and waits for the cancelled: up to 1 s.
  void close() override;
  bool is_open() const override;
  const FalconIdentity& identity() const override { return identity_; }
  LinkResult<std::size_t> control(const UsbSetup& setup, std::span<std::uint8_t> answer) override;
  /// Takes up to 512 bytes. What goes wrong on their way is told by the next call.
  LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t timeout_ms) override;
  /// One USB packet a call.
  LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) override;

 private:
  class Pipes;

  loop::Clock& clock_;
  std::string serial_;
  FalconIdentity identity_;
  std::unique_ptr<Pipes> pipes_;  ///< while open
};

}  // namespace isotouch::falcon
