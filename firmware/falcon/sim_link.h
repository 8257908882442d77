/// The link to a simulated Falcon over a local socket: one message is one request or one answer.
///
///   'D' → 'd' device descriptor of 18 bytes, then manufacturer, product, serial: u8 length and ASCII each
///   'C' setup of 8 bytes → 'c' status, data
///   'O' data → 'o' status, u16 accepted
///   'I' u16 capacity, u32 timeout_ms, never 0 → 'i' status, data as the FT232R frames it
///
/// status: 0 done, 1 stalled, 2 timed out, 3 gone. Little-endian. After "gone" the simulator closes; a replugged device is a new connection.
#pragma once

#include <string>
#include <vector>

#include "firmware/falcon/falcon_link.h"

namespace isotouch::falcon {

class SimLink final : public FalconLink {
 public:
  /// path      of the simulator's socket
  explicit SimLink(std::string path);
  ~SimLink() override;
  SimLink(const SimLink&) = delete;
  SimLink& operator=(const SimLink&) = delete;

  LinkResult<void> open() override;
  void close() override;
  bool is_open() const override { return socket_ >= 0; }
  const FalconIdentity& identity() const override { return identity_; }
  LinkResult<std::size_t> control(const UsbSetup& setup, std::span<std::uint8_t> answer) override;
  LinkResult<std::size_t> write(std::span<const std::uint8_t> data, std::uint32_t timeout_ms) override;
  LinkResult<std::size_t> read(std::span<std::uint8_t> buffer, std::uint32_t timeout_ms) override;

 private:
  LinkResult<std::span<const std::uint8_t>> ask(std::uint8_t kind, std::size_t size, std::uint32_t timeout_ms);
  LinkResult<std::span<const std::uint8_t>> ask_for_status(std::uint8_t kind, std::size_t size, std::uint32_t timeout_ms);
  bool take_identity(std::span<const std::uint8_t> answer);
  LinkError gone();

  std::string path_;
  int socket_ = -1;
  FalconIdentity identity_;
  std::vector<std::uint8_t> message_;  ///< the request, then the answer
};

}  // namespace isotouch::falcon
