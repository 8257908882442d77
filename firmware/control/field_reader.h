/// The reading of a field under way: whose it is. The image was copied, so that patches go on meanwhile. One at a time.
///
/// tick      no
#pragma once

#include <cstdint>

#include "firmware/control/control_client.h"
#include "firmware/store/field_intake.h"
#include "shared/files/refusal.h"
#include "shared/protocol_messages.h"

namespace isotouch::control {

class FieldReader {
 public:
  static constexpr std::int64_t kPatienceNs = 2'000'000'000;  ///< with a client that does not get on, where another one wants to read

  /// fields    holds the copy; lives longer
  explicit FieldReader(const store::FieldIntake& fields) : fields_(fields) {}

  /// This client reads from the first byte on; the image is to be copied anew.
  ///
  /// now_ns    of the caller's clock
  /// returns   why not: another client reads, or this many bytes cannot be read at once
  Refusal begin(const ControlClient& client, const protocol::ReadImage& wanted, std::int64_t now_ns);

  /// returns   why this part cannot be read: this client reads nothing, or the image has no such part
  Refusal go_on(const ControlClient& client, const protocol::ReadImage& wanted, std::int64_t now_ns);

  /// What was wanted last, of what was copied; after the last part nobody reads any more.
  protocol::ImagePart part();

  /// Ends the reading, if it is this client's.
  void drop(const ControlClient& client);

 private:
  Refusal want(const protocol::ReadImage& wanted, std::int64_t now_ns);

  const store::FieldIntake& fields_;
  const ControlClient* reader_ = nullptr;
  protocol::ReadImage wanted_;
  std::int64_t due_ns_ = 0;
};

}  // namespace isotouch::control
