#include "firmware/control/upload.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace isotouch::control {

namespace {
constexpr const char* kNoneHere = "no upload is under way on this connection; begin one";
}

/// No other client sends; what this one sent before is void.
Refusal Upload::claim(const ControlClient& client, std::int64_t now_ns) {
  if (is_under_way() && !is_from(client)) return std::string(kSomebodySends);
  if (!is_from(client)) due_ns_ = now_ns + patience_ns_;  // to begin again is no progress
  drop(client);
  return {};
}

Refusal Upload::begin(const ControlClient& client, const protocol::BeginPatch& promised, std::int64_t now_ns) {
  if (Refusal refusal = claim(client, now_ns)) return refusal;
  if (promised.bytes > fields_.upload().size()) {
    return "the patch takes " + std::to_string(promised.bytes) + " bytes, more than the " + std::to_string(fields_.upload().size()) +
           " that the largest field may take; send the whole field";
  }
  sender_ = &client;
  promised_ = {};
  promised_.packed_bytes = promised.bytes;
  is_patch_ = true;
  received_ = 0;
  return {};
}

Refusal Upload::begin(const ControlClient& client, const protocol::Begin& promised, std::int64_t now_ns) {
  if (Refusal refusal = claim(client, now_ns)) return refusal;
  if (promised.image_bytes > fields_.image_limit()) return store::too_large(promised.image_bytes, fields_.image_limit());
  if (promised.packed_bytes > fields_.upload().size()) {
    return "the packed field takes " + std::to_string(promised.packed_bytes) + " bytes, more than the " +
           std::to_string(fields_.upload().size()) + " that the largest field may take; build it again and send it again";
  }
  sender_ = &client;
  promised_ = promised;
  is_patch_ = false;
  received_ = 0;
  return {};
}

bool Upload::is_too_slow(const ControlClient& client, std::int64_t now_ns) const { return is_from(client) && now_ns > due_ns_; }

Refusal Upload::add(const ControlClient& client, const protocol::Chunk& piece, std::int64_t now_ns) {
  if (!is_from(client)) return kNoneHere;
  if (piece.offset != received_ || piece.bytes.size() > promised_.packed_bytes - received_) {
    drop(client);
    return "a piece of the upload does not follow the one before; send it again from the beginning";
  }
  std::copy(piece.bytes.begin(), piece.bytes.end(), fields_.upload().begin() + static_cast<std::ptrdiff_t>(received_));
  received_ += piece.bytes.size();
  constexpr std::int64_t kNsPerByte = 100'000;
  due_ns_ = std::min(due_ns_ + static_cast<std::int64_t>(piece.bytes.size()) * kNsPerByte, now_ns + patience_ns_);
  return {};
}

Refusal Upload::complete(const ControlClient& client, protocol::Begin& promised, bool& is_patch) {
  if (!is_from(client)) return kNoneHere;
  drop(client);
  if (received_ != promised_.packed_bytes) {
    return "the upload ended after " + std::to_string(received_) + " of " + std::to_string(promised_.packed_bytes) +
           " bytes; send it again from the beginning";
  }
  promised = promised_;
  is_patch = is_patch_;
  return {};
}

void Upload::drop(const ControlClient& client) {
  if (is_from(client)) sender_ = nullptr;
}

}  // namespace isotouch::control
