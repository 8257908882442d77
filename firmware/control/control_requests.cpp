#include "firmware/control/control_requests.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "firmware/control/rights.h"
#include "firmware/control/tick_report.h"
#include "shared/files/state_text.h"

namespace isotouch::control {

namespace {

using protocol::Kind;
using protocol::Role;

constexpr std::int64_t kMeasuringNs = 1'000'000'000;
constexpr std::int64_t kMeasuringPatienceNs = 5'000'000'000;

constexpr std::size_t kMostSettings = protocol::kMaxBody - 64;

constexpr std::string_view kMeasuringNow = "a calibration is being measured or stored; try again in a second";
constexpr std::string_view kNothingToCalibrate = "there is no device to calibrate; start the controller with a device";

void done_or_refused(ControlClient& client, Kind kind, const Refusal& refusal) {
  refusal ? client.refuse(kind, refusal.sentence()) : client.say(Kind::kDone);
}

}  // namespace

ControlRequests::ControlRequests(const TraceHeader& recordings, const ControlNeighbours& neighbours, std::span<ControlClient> clients,
                                 std::int64_t patience_ns)
    : recordings_(recordings),
      neighbours_(neighbours),
      clients_(clients),
      feed_(neighbours.ring, recordings_, neighbours.requests),
      worker_(neighbours.fields, neighbours.calibration),
      last_worked_for_(clients.size() - 1),
      upload_(neighbours.fields, patience_ns),
      reader_(neighbours.fields),
      scratch_(std::max(kHistogramScratch, protocol::kMaxBody)) {}

bool ControlRequests::go_on() {
  finish_work();
  const bool watched = feed_.pump(clients_, posture_, worst_, neighbours_.clock.now_ns());
  const bool busy = watched || measuring_ != nullptr;
  finish_measuring();
  return busy;
}

bool ControlRequests::is_in_use() const {
  return upload_.is_under_way() || is_working() || measuring_ != nullptr || !feed_.is_free(clients_);
}

void ControlRequests::forget(const ControlClient& client) {
  upload_.drop(client);
  reader_.drop(client);
  if (awaiting_ == &client) awaiting_ = nullptr;
  if (measuring_ == &client) measuring_ = nullptr;
}

/// What the field worker would do, or what touches its memory, comes after what it does now.
bool ControlRequests::must_wait(const protocol::Frame& frame) const {
  const bool needs_worker = frame.kind == Kind::kBegin || frame.kind == Kind::kBeginPatch || frame.kind == Kind::kCommit ||
                            frame.kind == Kind::kFields || frame.kind == Kind::kSelect || frame.kind == Kind::kCalibrate ||
                            frame.kind == Kind::kReadImage;
  return needs_worker && !worker_.is_idle();
}

void ControlRequests::answer(ControlClient& client, const protocol::Frame& frame) {
  const auto malformed = [&] {
    client.refuse(frame.kind, "the request is too short for its kind; install the same release on both sides");
  };
  if (!may(client, frame.kind, role_for(frame.kind))) return;
  // What may lead to a force is refused until the hand has been measured, and until what was measured holds. So is another measurement, and posture itself
  // looks whether one is under way. While angles are stored only a resume comes to here: commit and select wait for the worker before.
  const bool may_lead_to_force = frame.kind == Kind::kCommit || frame.kind == Kind::kSelect || frame.kind == Kind::kResume;
  if ((measuring_ != nullptr || worker_.keeps_angles()) && may_lead_to_force) return client.refuse(frame.kind, kMeasuringNow);
  const auto others = neighbours_.calibration != nullptr ? neighbours_.calibration->others() : protocol::OtherAngles::kNone;
  const bool needs_the_angles = may_lead_to_force || frame.kind == Kind::kPosture || frame.kind == Kind::kCalibrate;
  if (others != protocol::OtherAngles::kNone && needs_the_angles) return client.refuse(frame.kind, files::angles_text(others));
  switch (frame.kind) {
    case Kind::kBegin: {
      const auto promised = protocol::decode<protocol::Begin>(frame.body);
      return promised ? done_or_refused(client, frame.kind, upload_.begin(client, *promised, neighbours_.clock.now_ns())) : malformed();
    }
    case Kind::kBeginPatch: {
      const auto promised = protocol::decode<protocol::BeginPatch>(frame.body);
      return promised ? done_or_refused(client, frame.kind, upload_.begin(client, *promised, neighbours_.clock.now_ns())) : malformed();
    }
    case Kind::kChunk: {
      const auto piece = protocol::decode<protocol::Chunk>(frame.body);
      return piece ? done_or_refused(client, frame.kind, upload_.add(client, *piece, neighbours_.clock.now_ns())) : malformed();
    }
    case Kind::kCommit: return commit(client);
    case Kind::kAbort: upload_.drop(client); return client.say(Kind::kDone);
    case Kind::kStatus:
      return client.say(Kind::kStatusReport, status_report(neighbours_.shown.get(), neighbours_.stats, neighbours_.fields.published()));
    case Kind::kHistogram: {
      const auto wanted = protocol::decode<protocol::HistogramRequest>(frame.body);
      return wanted ? histogram(client, wanted->measure) : malformed();
    }
    case Kind::kSubscribe: {
      const auto wanted = protocol::decode<protocol::Subscribe>(frame.body);
      if (!wanted) return malformed();
      if (!feed_.is_there()) return client.refuse(frame.kind, "this controller shows no ticks; start it with its trace ring");
      if (client.records) return client.refuse(frame.kind, "this connection is recording; use another connection to watch");
      feed_.subscribe(client, wanted->every);
      return client.say(Kind::kDone);
    }
    case Kind::kRecord: return begin_recording(client);
    case Kind::kRecordEnd:
      if (client.records) feed_.end_recording(client);
      return client.say(Kind::kDone);
    case Kind::kStop:
      neighbours_.requests.ask(kRequestStop, author_of(client.user));
      log(client.user, "stop");
      return client.say(Kind::kDone);
    case Kind::kResume:
      if (!may(client, frame.kind, role_after(neighbours_.shown.get().faults))) return;
      neighbours_.requests.ask(kRequestResume, author_of(client.user));
      log(client.user, "resume");
      return client.say(Kind::kDone);
    case Kind::kFields:
      if (!neighbours_.fields.keeps_fields())
        return client.refuse(frame.kind,
                             "this controller keeps no fields, because it has no state folder; name one in its settings, [files] state");
      return start_work(client, FieldWork::Kind::kList, {});
    case Kind::kSelect: {
      const auto wanted = protocol::decode<protocol::Select>(frame.body);
      if (!wanted) return malformed();
      protocol::Begin field;
      field.image_hash = wanted->image_hash;
      return start_work(client, FieldWork::Kind::kSelect, field);
    }
    case Kind::kReadImage: {
      const auto wanted = protocol::decode<protocol::ReadImage>(frame.body);
      return wanted ? read_image(client, *wanted) : malformed();
    }
    case Kind::kDevice:
      if (neighbours_.calibration == nullptr) return client.refuse(frame.kind, kNothingToCalibrate);
      return client.say(Kind::kDeviceReport, neighbours_.calibration->report());
    case Kind::kPosture: return measure(client);
    case Kind::kCalibrate: {
      const auto measured = protocol::decode<protocol::Calibrate>(frame.body);
      return measured ? calibrate(client, *measured) : malformed();
    }
    case Kind::kSet: {
      const auto wanted = protocol::decode<protocol::Set>(frame.body);
      return wanted ? set(client, *wanted) : malformed();
    }
    case Kind::kSettings: return settings(client);
    case Kind::kWorst: {
      const auto wanted = protocol::decode<protocol::WorstRequest>(frame.body);
      if (!wanted) return malformed();
      if (!may(client, frame.kind, role_for_worst(wanted->anew != 0))) return;
      return worst(client, wanted->anew != 0);
    }
    default: client.refuse(frame.kind, "this controller does not know the request; install the same release on both sides");
  }
}

/// Has the client this role? Where not, it is told so.
bool ControlRequests::may(ControlClient& client, Kind request, Role wanted) {
  if (client.role >= wanted) return true;
  const std::string role(name_of(wanted));
  client.refuse(request, "this takes the role " + role + ", and user " + std::to_string(client.user) + " has the role " +
                             std::string(name_of(client.role)) + "; ask somebody who has it, or see [control] " + role + "_users and " +
                             role + "_groups in the controller's settings");
  return false;
}

void ControlRequests::log(std::uint32_t user, const std::string& change) const {
  if (neighbours_.log) neighbours_.log("user " + std::to_string(user) + ": " + change);
}

void ControlRequests::commit(ControlClient& client) {
  protocol::Begin promised;
  bool is_patch = false;
  const Refusal refusal = upload_.complete(client, promised, is_patch);
  if (refusal) return client.refuse(Kind::kCommit, refusal.sentence());
  start_work(client, is_patch ? FieldWork::Kind::kPatch : FieldWork::Kind::kAccept, promised);
}

/// The first part waits for a copy of the image.
void ControlRequests::read_image(ControlClient& client, const protocol::ReadImage& wanted) {
  const std::int64_t now = neighbours_.clock.now_ns();
  if (const Refusal refusal = wanted.offset == 0 ? reader_.begin(client, wanted, now) : reader_.go_on(client, wanted, now))
    return client.refuse(Kind::kReadImage, refusal.sentence());
  if (wanted.offset == 0) return start_work(client, FieldWork::Kind::kCopy, {});
  client.say(Kind::kImagePart, reader_.part());
}

void ControlRequests::start_work(ControlClient& client, FieldWork::Kind kind, const protocol::Begin& field) {
  // A stored field is read to where an upload is put together.
  if (kind == FieldWork::Kind::kSelect && upload_.is_under_way()) return client.refuse(Kind::kSelect, kSomebodySends);
  worker_.begin({kind, field, {}, client.user});
  await(client);
}

void ControlRequests::await(ControlClient& client) {
  awaiting_ = &client;
  last_worked_for_ = static_cast<std::size_t>(&client - clients_.data());
  client.waiting = true;
}

void ControlRequests::finish_work() {
  const std::optional<FieldDone> done = worker_.take();
  if (!done) return;
  if (!done->outcome.refusal) log_done(*done);
  ControlClient* client = std::exchange(awaiting_, nullptr);
  if (client == nullptr) return;
  client->waiting = false;
  if (done->kind == FieldWork::Kind::kCalibrate) return done_or_refused(*client, Kind::kCalibrate, done->outcome.refusal);
  if (done->kind == FieldWork::Kind::kCopy) {
    if (!done->outcome.refusal) return client->say(Kind::kImagePart, reader_.part());
    reader_.drop(*client);
    return client->refuse(Kind::kReadImage, done->outcome.refusal.sentence());
  }
  if (done->kind != FieldWork::Kind::kList) {
    if (!done->outcome.refusal) return client->say(Kind::kAccepted, done->outcome.field.accepted());
    return client->refuse(done->kind == FieldWork::Kind::kSelect ? Kind::kSelect : Kind::kCommit, done->outcome.refusal.sentence());
  }
  protocol::BodyWriter entries(scratch_);
  protocol::FieldList list;
  const std::uint64_t felt = neighbours_.fields.published().image_hash;
  for (const store::StoredField& stored : done->stored) {
    if (entries.used() + 128 > protocol::kMaxBody) break;
    const protocol::FieldEntry entry{stored.hash, stored.bytes, stored.hash == felt, protocol::Text::of(stored.name)};
    protocol::FieldEntry::fields(entry, entries);
    ++list.count;
  }
  list.entries = std::span(scratch_).first(entries.used());
  client->say(Kind::kFieldList, list);
}

void ControlRequests::log_done(const FieldDone& done) const {
  if (done.kind == FieldWork::Kind::kCalibrate) log(done.user, "other angles were stored for the device");
  if (done.kind == FieldWork::Kind::kList || done.kind == FieldWork::Kind::kCopy || done.kind == FieldWork::Kind::kCalibrate) return;
  if (done.kind == FieldWork::Kind::kPatch) return;  // thirty a second are no news
  const store::PublishedField& field = done.outcome.field;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " %016llx is active, generation %u", static_cast<unsigned long long>(field.image_hash),
                field.generation);
  log(done.user, "field " + std::string(field.name.view()) + text.data());
}

void ControlRequests::set(ControlClient& client, const protocol::Set& wanted) {
  if (!neighbours_.set) return client.refuse(Kind::kSet, "this controller's settings are fixed");
  const Refusal refusal = neighbours_.set(wanted.name.view(), wanted.value.view(), author_of(client.user), client.role >= Role::kService);
  if (!refusal) log(client.user, std::string(wanted.name.view()) + " = " + std::string(wanted.value.view()));
  done_or_refused(client, Kind::kSet, refusal);
}

void ControlRequests::settings(ControlClient& client) {
  std::string different = neighbours_.different ? neighbours_.different() : std::string();
  if (different.size() > kMostSettings) different.resize(different.rfind('\n', kMostSettings - 1) + 1);  // whole lines
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(different.data());
  client.say(Kind::kSettingsReport, protocol::SettingsReport{recordings_.settings_checksum, {bytes, different.size()}});
}

void ControlRequests::histogram(ControlClient& client, std::uint8_t measure) {
  if (measure >= protocol::kMeasures)
    return client.refuse(Kind::kHistogram, "this controller does not measure that; install the same release on both sides");
  client.say(Kind::kHistogramReport, histogram_report(static_cast<protocol::Measure>(measure), neighbours_.stats, scratch_));
}

void ControlRequests::worst(ControlClient& client, bool anew) {
  if (!feed_.is_there()) return client.refuse(Kind::kWorst, "this controller shows no ticks; start it with its trace ring");
  client.say(Kind::kWorstTicks, worst_report(worst_, scratch_));
  if (anew) worst_.begin_anew();
}

void ControlRequests::begin_recording(ControlClient& client) {
  if (!may(client, Kind::kRecord, role_after(neighbours_.shown.get().faults))) return;
  if (!feed_.is_there()) return client.refuse(Kind::kRecord, "this controller shows no ticks; start it with its trace ring");
  if (!feed_.is_free(clients_)) return client.refuse(Kind::kRecord, "another client is recording; try again when it has ended");
  feed_.record(client, neighbours_.fields.published().accepted());
  log(client.user, "a recording began");
}

/// Where the arms stand, over a second in which no force may begin.
void ControlRequests::measure(ControlClient& client) {
  if (!feed_.is_there()) return client.refuse(Kind::kPosture, "this controller shows no ticks; start it with its trace ring");
  if (neighbours_.calibration == nullptr) return client.refuse(Kind::kPosture, kNothingToCalibrate);
  if (neighbours_.calibration->report().serial.size == 0)
    return client.refuse(Kind::kPosture, "no device with a serial answers; plug it in, and see what isotouchd prints");
  if (measuring_ != nullptr || worker_.keeps_angles()) return client.refuse(Kind::kPosture, kMeasuringNow);
  if (!worker_.is_idle()) return client.refuse(Kind::kPosture, kSomebodySends);
  // The tick under way may not have heard of a stop yet.
  posture_.begin(static_cast<std::uint32_t>(kMeasuringNs / std::max(recordings_.period_ns, 1U)), neighbours_.shown.get().number + 1);
  measuring_ = &client;
  measured_by_ns_ = neighbours_.clock.now_ns() + kMeasuringPatienceNs;
  client.waiting = true;
}

void ControlRequests::finish_measuring() {
  const bool given_up = neighbours_.clock.now_ns() >= measured_by_ns_;
  if (measuring_ == nullptr || (!posture_.has_ended() && !given_up)) return;
  ControlClient& client = *std::exchange(measuring_, nullptr);
  client.waiting = false;
  if (!posture_.has_ended()) return client.refuse(Kind::kPosture, "the controller's loop does not run; restart the controller");
  if (posture_.refusal()) return client.refuse(Kind::kPosture, posture_.refusal().sentence());
  const DeviceModelBytes device = encode(recordings_.device);
  client.say(Kind::kPostureReport, protocol::PostureReport{neighbours_.calibration->report().serial, posture_.counts(), device});
}

void ControlRequests::calibrate(ControlClient& client, const protocol::Calibrate& measured) {
  if (neighbours_.calibration == nullptr) return client.refuse(Kind::kCalibrate, kNothingToCalibrate);
  FieldWork work;
  work.kind = FieldWork::Kind::kCalibrate;
  work.measured = measured;
  work.user = client.user;
  worker_.begin(work);
  await(client);
}

}  // namespace isotouch::control
