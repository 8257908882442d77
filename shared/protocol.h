/// The frames that host tool and controller exchange over a byte stream (SPEC.md, section 6). What their bodies say is `protocol_messages.h`.
///
/// Every request is answered by one frame, in order; what the controller sends unasked has a kind of its own. No allocation on either side of
/// these functions, and no bytes that make them fail otherwise than by an error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared/result.h"

namespace isotouch::protocol {

inline constexpr std::array<std::uint8_t, 4> kMagic = {'I', 'T', 'C', 'W'};
inline constexpr std::uint16_t kMajor = 2;
inline constexpr std::uint16_t kMinor = 1;
inline constexpr std::size_t kKindAt = 4;
inline constexpr std::size_t kLengthAt = 8;
inline constexpr std::size_t kChecksumAt = 12;
inline constexpr std::size_t kHeaderBytes = 16;
inline constexpr std::size_t kMaxBody = 1U << 16;
inline constexpr std::size_t kMaxFrame = kHeaderBytes + kMaxBody;

/// What a frame is. Below 128: requests.
enum class Kind : std::uint8_t {
  kHello = 1,    ///< Hello → kWelcome; the first frame of a connection
  kBegin,        ///< Begin → kDone
  kChunk,        ///< Chunk → kDone
  kCommit,       ///< nothing → kAccepted, once the field is active
  kAbort,        ///< nothing → kDone
  kStatus,       ///< nothing → kStatusReport
  kHistogram,    ///< HistogramRequest → kHistogramReport
  kSubscribe,    ///< Subscribe → kDone, then kRecords
  kRecord,       ///< nothing → kRecording, then kRecords; the first record begins a run that replays
  kRecordEnd,    ///< nothing → kDone, after the last kRecords
  kStop,         ///< nothing → kDone: no force until kResume
  kResume,       ///< nothing → kDone
  kFields,       ///< nothing → kFieldList
  kSelect,       ///< Select → kAccepted, once the field is active
  kBeginPatch,   ///< BeginPatch → kDone; then as after kBegin
  kReadImage,    ///< ReadImage → kImagePart
  kDevice = 20,  ///< nothing → kDeviceReport
  kPosture,      ///< nothing → kPostureReport, after a second in which the hand held still without any force
  kCalibrate,    ///< Calibrate → kDone, once it is kept
  kSet,          ///< Set → kDone: the setting holds from the next tick on, by a ramp
  kWorst,        ///< WorstRequest → kWorstTicks
  kSettings,     ///< nothing → kSettingsReport
  kDone = 128,   ///< answer without a body
  kWelcome,
  kAccepted,
  kStatusReport,
  kHistogramReport,
  kRecording,
  kFieldList,
  kImagePart,
  kDeviceReport = 140,
  kPostureReport,
  kWorstTicks,
  kSettingsReport,
  kRecords = 192,  ///< unasked
  kRefused = 255,  ///< Refusal, in place of an answer; or unasked, with the kind of what ended
};

/// One frame; borrows the bytes.
struct Frame {
  Kind kind{};
  std::span<const std::uint8_t> body;
  std::size_t size = 0;  ///< bytes of the whole frame; 0 = more bytes are needed
};

/// The frame at the front of a stream.
///
/// bytes     what has come and was not yet used; may be nothing
/// returns   the frame, or one of size 0 as long as it is not complete
/// fails     kBadMagic, kBadHeader (a reserved byte), kBadSize (a body above kMaxBody): as soon as the bytes that show it are there; kBadChecksum.
///           The stream has no use after that
/// tick      no: its time grows with the body
Result<Frame> read_frame(std::span<const std::uint8_t> bytes);

/// Writes a frame's header in front of a body that stands at `kHeaderBytes` of `frame` already.
///
/// body_bytes  at most kMaxBody
/// returns     bytes of the whole frame
std::size_t seal_frame(Kind kind, std::size_t body_bytes, std::span<std::uint8_t> frame);

}  // namespace isotouch::protocol
