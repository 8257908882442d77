#include "firmware/control/upload.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace isotouch::control {

namespace {
constexpr const char* kNoneHere = "no upload is under way on this connection; begin one";
}

Refusal Upload::begin(const ControlClient& client, const protocol::Begin& promised, std::int64_t now_ns) {
  drop(client);
  if (is_under_way()) return std::string(kSomebodySends);
  if (promised.image_bytes > fields_.image_limit()) return store::too_large(promised.image_bytes, fields_.image_limit());
  if (promised.packed_bytes > fields_.upload().size()) {
    return "the packed field takes " + std::to_string(promised.packed_bytes) + " bytes, more than the " +
           std::to_string(fields_.upload().size()) + " that the largest field may take; build it again and send it again";
  }
  sender_ = &client;
  promised_ = promised;
  received_ = 0;
  begun_ns_ = now_ns;
  return {};
}

bool Upload::is_too_slow(const ControlClient& client, std::int64_t now_ns, std::int64_t patience_ns) const {
  constexpr std::int64_t kNsPerByte = 100'000;
  return is_from(client) && now_ns - begun_ns_ > patience_ns + static_cast<std::int64_t>(received_) * kNsPerByte;
}

Refusal Upload::add(const ControlClient& client, const protocol::Chunk& piece) {
  if (!is_from(client)) return kNoneHere;
  if (piece.offset != received_ || piece.bytes.size() > promised_.packed_bytes - received_) {
    drop(client);
    return "a piece of the upload does not follow the one before; send it again from the beginning";
  }
  std::copy(piece.bytes.begin(), piece.bytes.end(), fields_.upload().begin() + static_cast<std::ptrdiff_t>(received_));
  received_ += piece.bytes.size();
  return {};
}

Refusal Upload::complete(const ControlClient& client, protocol::Begin& promised) {
  if (!is_from(client)) return kNoneHere;
  drop(client);
  if (received_ != promised_.packed_bytes) {
    return "the upload ended after " + std::to_string(received_) + " of " + std::to_string(promised_.packed_bytes) +
           " bytes; send it again from the beginning";
  }
  promised = promised_;
  return {};
}

void Upload::drop(const ControlClient& client) {
  if (is_from(client)) sender_ = nullptr;
}

}  // namespace isotouch::control
