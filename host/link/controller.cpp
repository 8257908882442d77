#include "host/link/controller.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "host/error.h"
#include "shared/printable.h"

namespace isotouch::link {

namespace {

using protocol::Kind;

constexpr int kAnswer = 10'000;
constexpr int kChecking = 120'000;  ///< a large field on a slow disk, somebody else's, too: the controller does one such work at a time
constexpr std::size_t kSentAhead =
    16;  ///< chunks, and questions for them, without their answers: a far controller is not waited for each time

/// Nothing that a terminal would obey.
std::string for_people(std::span<const std::uint8_t> bytes) {
  std::string text(bytes.begin(), bytes.end());
  make_printable(text, ' ');
  return text;
}

}  // namespace

Controller::Controller(const std::string& address, std::optional<int> longest_ms, std::function<bool()> is_over)
    : longest_ms_(longest_ms.value_or(std::numeric_limits<int>::max())),
      is_over_(std::move(is_over)),
      connection_(read_address(address), longest_ms.value_or(0), is_over_) {
  connection_.send(Kind::kHello, protocol::Hello{});
  welcome_ = read<protocol::Welcome>(expect(Kind::kWelcome, kGreetingMs));
}

protocol::StatusReport Controller::status() {
  connection_.send(Kind::kStatus);
  return read<protocol::StatusReport>(expect(Kind::kStatusReport, kAnswer));
}

Controller::Settings Controller::settings() {
  connection_.send(Kind::kSettings);
  const auto report = read<protocol::SettingsReport>(expect(Kind::kSettingsReport, kAnswer));
  Settings settings{report.checksum, {}};
  std::istringstream lines(std::string(report.different.begin(), report.different.end()));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t middle = line.find(" = ");
    if (middle == std::string::npos) complain("the list of settings cannot be read; install the same release on both sides");
    make_printable(line, ' ');
    settings.different.emplace_back(line.substr(0, middle), line.substr(middle + 3));
  }
  return settings;
}

Histogram Controller::histogram(protocol::Measure measure) {
  connection_.send(Kind::kHistogram, protocol::HistogramRequest{static_cast<std::uint8_t>(measure)});
  const auto report = read<protocol::HistogramReport>(expect(Kind::kHistogramReport, kAnswer));
  Histogram histogram{report.count, {}};
  for (std::size_t at = 0; at + protocol::kBinBytes <= report.bins.size(); at += protocol::kBinBytes) {
    histogram.bins.push_back(*protocol::decode<protocol::Bin>(report.bins.subspan(at, protocol::kBinBytes)));
  }
  return histogram;
}

protocol::Accepted Controller::upload(const protocol::Begin& field, std::span<const std::uint8_t> packed) {
  connection_.send(Kind::kBegin, field);
  return send_upload(packed);
}

protocol::Accepted Controller::patch(std::span<const std::uint8_t> patch) {
  connection_.send(Kind::kBeginPatch, protocol::BeginPatch{patch.size()});
  return send_upload(patch);
}

/// What was announced, its end, and what becomes of it.
protocol::Accepted Controller::send_upload(std::span<const std::uint8_t> packed) {
  (void)expect(Kind::kDone, kChecking);
  std::size_t unanswered = 0;
  try {
    for (std::size_t at = 0; at < packed.size(); at += protocol::kMaxChunk) {
      connection_.send(Kind::kChunk, protocol::Chunk{at, packed.subspan(at, std::min(protocol::kMaxChunk, packed.size() - at))});
      for (++unanswered; unanswered == kSentAhead || (unanswered > 0 && connection_.has_input()); --unanswered)
        (void)expect(Kind::kDone, kAnswer);
    }
    for (; unanswered > 0; --unanswered) (void)expect(Kind::kDone, kAnswer);
  } catch (const InputError&) {
    if (unanswered > 0) pass_over(unanswered - 1);
    throw;
  }
  connection_.send(Kind::kCommit);
  return read<protocol::Accepted>(expect(Kind::kAccepted, kChecking));
}

Controller::Image Controller::image() {
  Image image;
  std::uint64_t bytes = 1, asked = 0;
  std::size_t unanswered = 0;
  const auto ask = [&] {
    connection_.send(Kind::kReadImage, protocol::ReadImage{asked, protocol::kMaxChunk});
    asked += protocol::kMaxChunk;
    ++unanswered;
  };
  const auto next = [&] {
    try {
      return read<protocol::ImagePart>(expect(Kind::kImagePart, kChecking));
    } catch (const InputError&) {
      pass_over(unanswered - 1);
      throw;
    }
  };
  for (ask(); unanswered > 0; --unanswered) {
    const auto part = next();
    if (part.offset == 0) image.hash = part.image_hash, bytes = part.image_bytes;
    const std::uint64_t wanted = std::min<std::uint64_t>(protocol::kMaxChunk, bytes - image.bytes.size());
    if (part.image_hash != image.hash || part.image_bytes != bytes || part.offset != image.bytes.size() || part.bytes.size() != wanted ||
        wanted == 0) {
      connection_.end_conversation();
      complain("a part of the field does not follow the one before; install the same release on both sides");
    }
    image.bytes.insert(image.bytes.end(), part.bytes.begin(), part.bytes.end());
    while (unanswered < kSentAhead && asked < bytes) ask();
  }
  return image;
}

std::vector<protocol::FieldEntry> Controller::fields() {
  connection_.send(Kind::kFields);
  const auto list = read<protocol::FieldList>(expect(Kind::kFieldList, kChecking));
  std::vector<protocol::FieldEntry> fields(list.count);
  protocol::BodyReader entries(list.entries);
  for (protocol::FieldEntry& entry : fields) protocol::FieldEntry::fields(entry, entries);
  if (!entries.is_good()) complain("a list of fields is shorter than it says; install the same release on both sides");
  return fields;
}

protocol::Accepted Controller::select(std::uint64_t image_hash) {
  connection_.send(Kind::kSelect, protocol::Select{image_hash});
  return read<protocol::Accepted>(expect(Kind::kAccepted, kChecking));
}

protocol::DeviceReport Controller::device() {
  connection_.send(Kind::kDevice);
  return read<protocol::DeviceReport>(expect(Kind::kDeviceReport, kAnswer));
}

protocol::PostureReport Controller::posture(DeviceModel& model) {
  connection_.send(Kind::kPosture);
  auto posture = read<protocol::PostureReport>(expect(Kind::kPostureReport, kAnswer));
  DeviceModelBytes bytes{};
  const bool whole = posture.device.size() == bytes.size();
  if (whole) std::copy(posture.device.begin(), posture.device.end(), bytes.begin());
  const Result<DeviceModel> decoded = decode_model(bytes);
  if (!whole || !decoded) complain("the device model in use cannot be read; install the same release on both sides");
  model = *decoded;
  posture.device = {};
  return posture;
}

void Controller::calibrate(const protocol::Calibrate& measured) {
  connection_.send(Kind::kCalibrate, measured);
  (void)expect(Kind::kDone, kChecking);
}

std::vector<protocol::WorstTick> Controller::worst_ticks(bool anew) {
  connection_.send(Kind::kWorst, protocol::WorstRequest{static_cast<std::uint8_t>(anew ? 1 : 0)});
  const auto report = read<protocol::WorstTicks>(expect(Kind::kWorstTicks, kAnswer));
  std::vector<protocol::WorstTick> worst;
  for (std::size_t at = 0; at + protocol::kWorstTickBytes <= report.ticks.size(); at += protocol::kWorstTickBytes) {
    worst.push_back(*protocol::decode<protocol::WorstTick>(report.ticks.subspan(at, protocol::kWorstTickBytes)));
  }
  return worst;
}

void Controller::stop() {
  connection_.send(Kind::kStop);
  (void)expect(Kind::kDone, kAnswer);
}

void Controller::set(const std::string& name, const std::string& value) {
  for (const auto& [what, text] : {std::pair("name", &name), std::pair("value", &value)}) {  // a message would cut what is longer
    if (text->size() <= protocol::kMaxName && is_printable(*text)) continue;
    complain("the setting's " + std::string(what) + " has more than " + std::to_string(protocol::kMaxName) +
             " bytes, or characters that cannot be printed, so nothing was set; write it shorter");
  }
  connection_.send(Kind::kSet, protocol::Set{protocol::Text::of(name), protocol::Text::of(value)});
  (void)expect(Kind::kDone, kAnswer);
}

void Controller::resume() {
  connection_.send(Kind::kResume);
  (void)expect(Kind::kDone, kAnswer);
}

/// The next records of those that come without being asked for.
///
/// taken     so many have come before: as long as there are none, what goes wrong is thrown
/// ended     why there are no more
/// returns   nothing: no more are wanted, or will come
std::optional<protocol::Records> Controller::more_records(std::uint64_t taken, int patience_ms, const std::function<bool()>& enough,
                                                          std::string& ended) {
  try {
    if (enough()) return std::nullopt;
    const auto records = read<protocol::Records>(required(Kind::kRecords, connection_.receive(patience_ms, enough)));
    if (records.record_bytes == 0 || records.bytes.size() % records.record_bytes != 0)
      complain("records of the ticks are cut; install the same release on both sides");
    return records;
  } catch (const InputError& error) {
    if (enough()) return std::nullopt;  // what interrupts us interrupts the ssh beside us
    if (taken == 0) throw;
    ended = error.what();
    return std::nullopt;
  }
}

std::string Controller::record(std::uint64_t ticks, const std::function<void(std::span<const std::uint8_t>)>& header,
                               const std::function<void(std::span<const std::uint8_t>)>& record, const std::function<bool()>& enough) {
  connection_.send(Kind::kRecord);
  header(read<protocol::Recording>(expect(Kind::kRecording, kAnswer)).header);
  std::string ended;
  std::uint64_t next = 0;
  for (std::uint64_t taken = 0; taken < ticks;) {
    const auto more = more_records(taken, patient(kAnswer), enough, ended);
    if (!more) return ended;
    if (taken > 0 && more->first_tick != next) return connection_.address().text + ": the recording has a gap; record again";
    for (std::size_t at = 0; at < more->bytes.size() && taken < ticks; at += more->record_bytes, ++taken) {
      record(more->bytes.subspan(at, more->record_bytes));
    }
    next = more->first_tick + more->bytes.size() / more->record_bytes;
  }
  return {};
}

Controller::Watched Controller::watch(std::uint32_t every, std::uint64_t records,
                                      const std::function<void(std::uint64_t, std::span<const std::uint8_t>)>& record,
                                      const std::function<bool()>& enough, const std::function<void()>& paused) {
  connection_.send(Kind::kSubscribe, protocol::Subscribe{every});
  (void)expect(Kind::kDone, kAnswer);
  const int patience_ms = patient(kAnswer) + static_cast<int>(std::min(1e8, every * (welcome_.period_ns / 1e6)));  // they may be far apart
  Watched watched;
  for (std::uint64_t taken = 0; taken < records;) {
    const auto more = more_records(taken, patience_ms, enough, watched.ended);
    if (!more) return watched;
    watched.lost = more->lost;
    std::uint64_t tick = more->first_tick;
    for (std::size_t at = 0; at < more->bytes.size() && taken < records; at += more->record_bytes, ++taken, tick += more->every) {
      record(tick, more->bytes.subspan(at, more->record_bytes));
    }
    if (paused && !connection_.has_input()) paused();
  }
  return watched;
}

/// The answer of that kind. Whatever else comes ends the conversation.
protocol::Frame Controller::expect(Kind kind, int patience_ms) { return required(kind, connection_.receive(patient(patience_ms))); }

/// The answers to what was sent behind a request that was refused: none of them passes for the answer to what is asked next.
void Controller::pass_over(std::size_t answers) {
  try {
    for (; answers > 0 && !connection_.has_ended(); --answers) (void)connection_.receive(patient(kAnswer));
  } catch (const InputError&) {  // nothing more can be asked, and why is known
  }
}

protocol::Frame Controller::required(Kind kind, const protocol::Frame& frame) {
  if (frame.kind == kind) return frame;
  if (frame.kind == Kind::kRefused) complain(for_people(read<protocol::Refusal>(frame).sentence));
  connection_.end_conversation();
  complain("the controller's answer does not fit the request; install the same release on both sides");
}

template <class Message>
Message Controller::read(const protocol::Frame& frame) {
  const Result<Message> message = protocol::decode<Message>(frame.body);
  if (!message) complain("an answer is too short for its kind; install the same release on both sides");
  return *message;
}

void Controller::complain(const std::string& sentence) { throw InputError(connection_.address().text + ": " + sentence); }

}  // namespace isotouch::link
