/// A value, or the one reason why there is none. Member names as in C++23's std::expected, which will replace it.
#pragma once

#include <cassert>
#include <cstdint>
#include <type_traits>

namespace isotouch {

/// Why data was refused. `describe` gives the core of a sentence; the caller adds file and place.
enum class Error : std::uint8_t {
  kTruncated,       ///< fewer bytes than the header promises
  kBadMagic,        ///< not a file of this kind
  kBadVersion,      ///< a major version that this program does not know
  kBadHeader,       ///< a header field outside its range
  kBadSize,         ///< the sizes in the header contradict each other or the file
  kBadChecksum,     ///< the bytes were changed after they were written
  kBadIndex,        ///< a table entry that SPEC.md 2.2 does not allow, or a border that is not far outside
  kMisaligned,      ///< the memory image does not start on an 8-byte boundary
  kBadRecord,       ///< a trace record with an undefined bit or value
  kWrongField,      ///< the trace was recorded on another field
  kNoOutputs,       ///< the trace holds inputs only
  kBadFrame,        ///< the compressed part of a packed field does not hold what its header promises
  kTooStiff,        ///< stiffer than the device can render without feeding energy into the hand
  kTooSteep,        ///< gradients above 2 that no certificate tells of
  kBadCertificate,  ///< a certificate that contradicts itself or the field
  kBadPacket,       ///< a device packet that lost or changed bytes on its way
  kBadMessage,      ///< a message that breaks the protocol
  kBadModel,        ///< a device model with a number outside its range
  kBadMarks,        ///< marks of invented surface that do not fit the bricks of their field
  kBadSample,       ///< a number of a field that is beyond its band
  kOtherField,      ///< a patch for another field than the one that is there
  kNoPatches,       ///< a recording of a field that was patched, without the patch that a tick takes over
  kBadPatch,        ///< a patch with a cell that is out of order, unknown, constant though stored, or unchanged
};

constexpr const char* describe(Error error) {
  switch (error) {
    case Error::kTruncated: return "the file ends before the size that its header states";
    case Error::kBadMagic: return "it is not a file of this kind";
    case Error::kBadVersion: return "it has another format version than this program reads: use the program that wrote it";
    case Error::kBadHeader: return "a header field is outside its range";
    case Error::kBadSize: return "the sizes in its header contradict each other";
    case Error::kBadChecksum: return "the checksum does not match: the bytes were changed after they were written";
    case Error::kBadIndex: return "a table entry in it is out of place, or its border is not far outside";
    case Error::kMisaligned: return "the memory image is not aligned to 8 bytes";
    case Error::kBadRecord: return "a record holds an undefined value";
    case Error::kWrongField: return "the trace was recorded on another field";
    case Error::kNoOutputs: return "the trace holds inputs only, there is nothing to compare with";
    case Error::kBadFrame: return "its compressed part does not match its header";
    case Error::kTooStiff: return "its stiffness would feed energy into the hand";
    case Error::kTooSteep:
      return "its distances rise by more than 2 voxels between neighbours, which a field without a certificate may not";
    case Error::kBadCertificate: return "its certificate contradicts itself or the samples";
    case Error::kBadPacket: return "the device packet is malformed";
    case Error::kBadMessage: return "a message does not follow the protocol";
    case Error::kBadModel: return "the device model holds a number outside its range";
    case Error::kBadMarks: return "its marks of invented surface do not fit its bricks";
    case Error::kBadSample: return "a distance in it is beyond the band that its header states";
    case Error::kOtherField: return "it was made for another field";
    case Error::kNoPatches: return "the field was patched while it was recorded, and a patch is missing";
    case Error::kBadPatch: return "a cell in it is out of order, is none, or does not change";
  }
  return "unknown error";
}

/// E   the enumeration of reasons: Error for data that both sides read; what only one folder does has an enumeration of its own
template <class T, class E = Error>
class [[nodiscard]] Result {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  constexpr Result(const T& value) : value_(value), ok_(true) {}  // NOLINT(google-explicit-constructor): as std::expected
  constexpr Result(E error) : error_(error), ok_(false) {}        // NOLINT(google-explicit-constructor): as std::unexpected

  constexpr bool has_value() const { return ok_; }
  constexpr explicit operator bool() const { return ok_; }
  constexpr const T& value() const { return assert(ok_), value_; }
  constexpr const T& operator*() const { return value(); }
  constexpr const T* operator->() const { return &value(); }
  constexpr E error() const { return assert(!ok_), error_; }

 private:
  T value_{};
  E error_{};
  bool ok_;
};

/// Done, or the one reason why not.
template <class E>
class [[nodiscard]] Result<void, E> {
 public:
  constexpr Result() = default;
  constexpr Result(E error) : error_(error), ok_(false) {}  // NOLINT(google-explicit-constructor): as std::unexpected

  constexpr bool has_value() const { return ok_; }
  constexpr explicit operator bool() const { return ok_; }
  constexpr E error() const { return assert(!ok_), error_; }

 private:
  E error_{};
  bool ok_ = true;
};

}  // namespace isotouch
