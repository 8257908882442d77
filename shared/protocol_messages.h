/// What the bodies of the protocol's frames say (SPEC.md, section 6.2). Each message lists its fields once, for reading and for writing; a body may be
/// longer than its message, because a minor version only adds at the end. No allocation; texts and spans borrow the body.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "shared/bytes.h"
#include "shared/protocol.h"
#include "shared/result.h"

namespace isotouch::protocol {

inline constexpr std::size_t kMaxName = 63;
inline constexpr std::size_t kMaxSentence = 1000;
inline constexpr std::size_t kMaxChunk = 1U << 15;

/// One line for people: UTF-8 that a terminal may get, see `printable.h`.
struct Text {
  std::array<char, kMaxName> characters{};
  std::uint8_t size = 0;

  std::string_view view() const { return {characters.data(), size}; }
  /// The text as far as it fits; bytes of what a terminal must not get become blanks.
  static Text of(std::string_view text);

  bool operator==(const Text&) const = default;
};

/// Fills a message from a body. What does not fit is zero, and `is_good` false from there on.
class BodyReader {
 public:
  explicit BodyReader(std::span<const std::uint8_t> body) : body_(body) {}
  template <std::integral T>
  void operator()(T& value) {
    const auto bytes = take(sizeof(T));
    value = bytes.empty() ? T{} : load_le<T>(bytes.data());
  }
  void operator()(Text& text);
  /// The rest of the body, whatever its length.
  void operator()(std::span<const std::uint8_t>& rest) { rest = body_, body_ = {}; }
  bool is_good() const { return good_; }

 private:
  std::span<const std::uint8_t> take(std::size_t bytes);
  std::span<const std::uint8_t> body_;
  bool good_ = true;
};

/// Writes a message into a body that has room for it.
class BodyWriter {
 public:
  explicit BodyWriter(std::span<std::uint8_t> body) : body_(body) {}
  template <std::integral T>
  void operator()(const T& value) {
    assert(body_.size() - used_ >= sizeof(T));
    store_le(&body_[used_], value);
    used_ += sizeof(T);
  }
  void operator()(const Text& text);
  void operator()(const std::span<const std::uint8_t>& rest);
  std::size_t used() const { return used_; }

 private:
  std::span<std::uint8_t> body_;
  std::size_t used_ = 0;
};

/// What a user may ask of a controller; each role may do what those before it may.
enum class Role : std::uint8_t {
  kNone,     ///< is not let in
  kWatch,    ///< see everything, and stop
  kOperate,  ///< send and choose fields, change settings within the limits, record, resume
  kService,  ///< raise limits, calibrate, resume after a fault of lines, memory or guard
};
inline constexpr std::array<std::string_view, 4> kRoleNames = {"none", "watch", "operate", "service"};

constexpr std::string_view name_of(Role role) {
  const auto number = static_cast<std::size_t>(role);
  return number < kRoleNames.size() ? kRoleNames[number] : "unknown";
}

struct Hello {
  std::uint16_t major = kMajor, minor = kMinor;
  static void fields(auto& m, auto& use) { use(m.major), use(m.minor); }
};

struct Welcome {
  std::uint16_t major = kMajor, minor = kMinor;
  std::uint32_t period_ns = 0;    ///< of a tick
  std::uint64_t image_limit = 0;  ///< bytes of a field's image, at most
  Text program;                   ///< name and version
  std::uint8_t role = 0;          ///< Role of the client
  static void fields(auto& m, auto& use) { use(m.major), use(m.minor), use(m.period_ns), use(m.image_limit), use(m.program), use(m.role); }
};

struct Begin {
  std::uint64_t packed_bytes = 0;  ///< of the upload: a packed field
  std::uint64_t image_bytes = 0;   ///< of the image that it holds
  std::uint64_t image_hash = 0;
  Text name;  ///< for people
  static void fields(auto& m, auto& use) { use(m.packed_bytes), use(m.image_bytes), use(m.image_hash), use(m.name); }
};

struct BeginPatch {
  std::uint64_t bytes = 0;  ///< of the patch (SPEC.md, section 7)
  static void fields(auto& m, auto& use) { use(m.bytes); }
};

struct Chunk {
  std::uint64_t offset = 0;  ///< of the first byte in the upload; chunks come in order
  std::span<const std::uint8_t> bytes;
  static void fields(auto& m, auto& use) { use(m.offset), use(m.bytes); }
};

struct ReadImage {
  std::uint64_t offset =
      0;  ///< of the first byte that is wanted; 0: of the field that is felt now, else of the field whose first part was read
  std::uint32_t bytes = 0;  ///< that are wanted, 1 to kMaxChunk
  static void fields(auto& m, auto& use) { use(m.offset), use(m.bytes); }
};

struct ImagePart {
  std::uint64_t image_hash = 0;
  std::uint64_t image_bytes = 0;  ///< of the whole image
  std::uint64_t offset = 0;
  std::span<const std::uint8_t> bytes;  ///< as many as were wanted, or the last ones
  static void fields(auto& m, auto& use) { use(m.image_hash), use(m.image_bytes), use(m.offset), use(m.bytes); }
};

struct Accepted {
  std::uint64_t image_hash = 0;
  std::uint32_t generation = 0;  ///< of the field, as a trace's inputs tell it
  static void fields(auto& m, auto& use) { use(m.image_hash), use(m.generation); }
};

/// Upper bounds of so many of the values seen since start: half of them, all but one in a thousand, all.
struct Quantiles {
  std::uint32_t p50 = 0, p999 = 0, max = 0;
};

/// What is measured, in the order of StatusReport; the number of a histogram.
enum class Measure : std::uint8_t { kWakeup, kTick, kRoundTrip, kDelay };
inline constexpr std::size_t kMeasures = 4;

struct StatusReport {
  std::uint16_t state = 0;   ///< SupervisorState
  std::uint16_t faults = 0;  ///< Faults: all that no person has resumed after, those before a restart among them
  std::uint32_t generation = 0;
  std::uint64_t ticks = 0;
  std::uint64_t late = 0;        ///< ticks that began after their due time by more than the limit
  std::uint64_t field_hash = 0;  ///< 0 = none
  std::uint64_t allocations = 0;
  std::uint64_t page_faults = 0;
  std::array<Quantiles, kMeasures> measures;  ///< ns; the delay from reply to commands in ticks
  std::uint32_t status = 0;                   ///< StatusBits of the last tick
  std::uint16_t age = 0;                      ///< of its sample, ticks
  std::uint8_t lines = 0;                     ///< LineBits of the last tick
  Text field_name;                            ///< empty: no field, or one without a name
  static void fields(auto& m, auto& use) {
    use(m.state), use(m.faults), use(m.generation), use(m.ticks), use(m.late), use(m.field_hash), use(m.allocations), use(m.page_faults);
    for (auto& q : m.measures) use(q.p50), use(q.p999), use(q.max);
    use(m.status), use(m.age), use(m.lines), use(m.field_name);
  }
};

struct SettingsReport {
  std::uint64_t checksum = 0;  ///< of all settings as the controller was started with them; recordings carry it
  std::span<const std::uint8_t>
      different;  ///< those that differ now from their default: "section.name = value" each, by newlines; printable
  static void fields(auto& m, auto& use) { use(m.checksum), use(m.different); }
};

struct HistogramRequest {
  std::uint8_t measure = 0;  ///< Measure
  static void fields(auto& m, auto& use) { use(m.measure); }
};

/// One filled class of a histogram: so many values of at most `upper`, and above the class before.
struct Bin {
  std::uint32_t upper = 0;
  std::uint64_t count = 0;
  static void fields(auto& m, auto& use) { use(m.upper), use(m.count); }
};
inline constexpr std::size_t kBinBytes = 12;

struct HistogramReport {
  std::uint8_t measure = 0;
  std::uint64_t count = 0;
  std::span<const std::uint8_t> bins;  ///< of kBinBytes each, by rising `upper`
  static void fields(auto& m, auto& use) { use(m.measure), use(m.count), use(m.bins); }
};

struct WorstRequest {
  std::uint8_t anew = 0;  ///< 1: those before are forgotten, for every client; the answer is of what was before
  static void fields(auto& m, auto& use) { use(m.anew); }
};

/// A tick whose commands came late.
struct WorstTick {
  std::uint64_t number = 0;
  std::int64_t start_ns = 0;  ///< when it began, CLOCK_MONOTONIC of the controller's machine
  std::uint32_t wake_ns = 0;  ///< from when it should have begun
  std::uint32_t tick_ns = 0;  ///< from its begin to its words being left
  static void fields(auto& m, auto& use) { use(m.number), use(m.start_ns), use(m.wake_ns), use(m.tick_ns); }
};
inline constexpr std::size_t kWorstTickBytes = 24;

struct WorstTicks {
  std::uint64_t seen = 0;               ///< ticks that these are the worst of
  std::span<const std::uint8_t> ticks;  ///< of kWorstTickBytes each, the latest commands first
  static void fields(auto& m, auto& use) { use(m.seen), use(m.ticks); }
};

struct Subscribe {
  std::uint32_t every = 0;  ///< one record every so many ticks; 0 = none
  static void fields(auto& m, auto& use) { use(m.every); }
};

struct Recording {
  std::span<const std::uint8_t> header;  ///< of the trace; its record count is 0
  static void fields(auto& m, auto& use) { use(m.header); }
};

struct Records {
  std::uint64_t first_tick = 0;         ///< of the first record
  std::uint32_t every = 0;              ///< ticks from one record to the next
  std::uint32_t record_bytes = 0;       ///< of the trace's version
  std::uint64_t lost = 0;               ///< records that were not sent since the subscription began, because this client read too slowly
  std::span<const std::uint8_t> bytes;  ///< records of a trace; the chain is zero where no recording was asked for
  static void fields(auto& m, auto& use) { use(m.first_tick), use(m.every), use(m.record_bytes), use(m.lost), use(m.bytes); }
};

/// A stored field.
struct FieldEntry {
  std::uint64_t image_hash = 0;
  std::uint64_t packed_bytes = 0;
  std::uint8_t active = 0;
  Text name;
  static void fields(auto& m, auto& use) { use(m.image_hash), use(m.packed_bytes), use(m.active), use(m.name); }
};

struct FieldList {
  std::uint16_t count = 0;
  std::span<const std::uint8_t> entries;  ///< FieldEntry, one after the other
  static void fields(auto& m, auto& use) { use(m.count), use(m.entries); }
};

struct Select {
  std::uint64_t image_hash = 0;
  static void fields(auto& m, auto& use) { use(m.image_hash); }
};

/// Where a controller has the angles of the arms at count 0 from.
enum class AnglesFrom : std::uint8_t { kGeometry, kSettings, kMeasured };

/// Whether the device that answers has other angles than those in use, which hold from the controller's next start on.
enum class OtherAngles : std::uint8_t {
  kNone,
  kKept,      ///< they were measured meanwhile, so it is not heard any more and gets no force
  kUntrusted  ///< those in use are not its own, so it is not heard and gets no force
};

struct DeviceReport {
  Text serial;                             ///< of the device that answers; empty: none, or it has none
  std::uint8_t from = 0;                   ///< AnglesFrom
  std::uint8_t waits = 0;                  ///< OtherAngles
  std::array<std::uint32_t, 3> at_zero{};  ///< in use: of the arms at count 0, 2^32 to the turn, legs 1 to 3
  static void fields(auto& m, auto& use) {
    use(m.serial), use(m.from), use(m.waits);
    for (auto& angle : m.at_zero) use(angle);
  }
};

/// Where the arms stood while a hand held still.
struct PostureReport {
  Text serial;                           ///< of the device
  std::array<std::int32_t, 3> counts{};  ///< means, 8 fraction bits
  std::span<const std::uint8_t> device;  ///< the device model in use, as in a trace's header
  static void fields(auto& m, auto& use) {
    use(m.serial);
    for (auto& count : m.counts) use(count);
    use(m.device);
  }
};

struct Calibrate {
  Text serial;                             ///< of the device that was measured
  std::array<std::uint32_t, 3> at_zero{};  ///< as in DeviceReport
  static void fields(auto& m, auto& use) {
    use(m.serial);
    for (auto& angle : m.at_zero) use(angle);
  }
};

/// A setting that may change while it is felt.
struct Set {
  Text name;
  Text value;  ///< as in the settings' file
  static void fields(auto& m, auto& use) { use(m.name), use(m.value); }
};

struct Refusal {
  std::uint8_t request = 0;                ///< Kind that is refused, or that ended
  std::span<const std::uint8_t> sentence;  ///< UTF-8, at most kMaxSentence bytes: what is wrong and what to do
  static void fields(auto& m, auto& use) { use(m.request), use(m.sentence); }
};

/// fails     kBadMessage: the body is shorter than the message, or a text holds control characters
template <class Message>
Result<Message> decode(std::span<const std::uint8_t> body) {
  Message message;
  BodyReader reader(body);
  Message::fields(message, reader);
  if (!reader.is_good()) return Error::kBadMessage;
  return message;
}

/// A whole frame with this message.
///
/// frame     with room for it: kMaxFrame is always enough
/// returns   bytes of the frame
template <class Message>
std::size_t encode(Kind kind, const Message& message, std::span<std::uint8_t> frame) {
  BodyWriter writer(frame.subspan(kHeaderBytes));
  Message::fields(message, writer);
  return seal_frame(kind, writer.used(), frame);
}

}  // namespace isotouch::protocol
