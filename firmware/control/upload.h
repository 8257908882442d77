/// The upload under way, a field or a patch: what a client has promised, and how much of it is there. One at a time.
///
/// tick      no
#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/control/control_client.h"
#include "firmware/store/field_intake.h"
#include "shared/files/refusal.h"
#include "shared/protocol.h"

namespace isotouch::control {

inline constexpr std::string_view kSomebodySends = "another client is sending a field; try again when that has ended";

class Upload {
 public:
  /// fields    where an upload is put together; lives longer
  /// patience_ns   with a client that does not get on
  Upload(store::FieldIntake& fields, std::int64_t patience_ns) : fields_(fields), patience_ns_(patience_ns) {}

  bool is_under_way() const { return sender_ != nullptr; }
  bool is_from(const ControlClient& client) const { return sender_ == &client; }

  /// Begins one; the same client's earlier one is void.
  ///
  /// now_ns    of the caller's clock
  /// returns   why not: another client sends, or there is no room for it
  Refusal begin(const ControlClient& client, const protocol::Begin& promised, std::int64_t now_ns);
  /// The same of a patch.
  Refusal begin(const ControlClient& client, const protocol::BeginPatch& promised, std::int64_t now_ns);

  /// Whether this client's upload gets on by less than 10,000 bytes a second, and its patience is used up: it would keep everybody else from sending one.
  bool is_too_slow(const ControlClient& client, std::int64_t now_ns) const;

  /// Takes the next piece. One that does not follow the piece before ends the upload.
  Refusal add(const ControlClient& client, const protocol::Chunk& piece, std::int64_t now_ns);

  /// Ends it, as complete: `promised` is then all there; of a patch it says the bytes alone.
  ///
  /// returns   why not; then it has ended too
  Refusal complete(const ControlClient& client, protocol::Begin& promised, bool& is_patch);

  /// Ends it, if it is this client's.
  void drop(const ControlClient& client);

 private:
  Refusal claim(const ControlClient& client, std::int64_t now_ns);

  store::FieldIntake& fields_;
  const ControlClient* sender_ = nullptr;
  protocol::Begin promised_;
  bool is_patch_ = false;
  std::uint64_t received_ = 0;
  std::int64_t patience_ns_;
  std::int64_t due_ns_ = 0;  ///< when the upload is too slow; each byte puts it off, but never beyond the patience
};

}  // namespace isotouch::control
