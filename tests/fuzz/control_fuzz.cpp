/// The control server with several clients at once. The input is a sequence of what clients, tick, clock and storage do. After each step these hold:
/// a stop is possible, nothing is felt that was not sent whole and checked, and nobody does more than the role allows. At the end no descriptor, place,
/// upload or recording is left over.
///
/// Everything but the field worker runs in the server's thread: it asks for events through the seam `ControlSettings::poll`, and the next step is done
/// there. Time passes only by steps, and where the worker waits for the tick.
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>

#include "firmware/control/control_server.h"
#include "tests/firmware/store/crashing_folder.h"
#include "tests/firmware/store/packed_field.h"
#include "tests/fuzz/input.h"

using namespace isotouch;
using namespace isotouch::control;
using protocol::Kind, protocol::Role;

namespace {

constexpr std::size_t kClients = 3, kPlaces = 2, kBalls = 6, kRefusedBall = 5, kChunk = 900;
constexpr std::size_t kImageLimit = 1 << 16, kRing = 2048;
constexpr int kMaxRounds = 10'000;   // of a millisecond at least, until what must come counts as missing
constexpr uid_t kFirstUser = 71000;  // the user of each role comes one after the other, from none on
constexpr Role kWatch = Role::kWatch, kOperate = Role::kOperate, kService = Role::kService;

const store::PackedField& ball(std::size_t which) {
  static const std::vector<store::PackedField> all = [] {
    std::vector<store::PackedField> made;
    for (std::size_t i = 0; i < kBalls; ++i) made.push_back(store::packed_ball(static_cast<int>(i)));
    return made;
  }();
  return all[which % kBalls];
}

Role role_of_user(std::uint64_t user) {
  fuzz::hold(user >= kFirstUser && user <= kFirstUser + 3, "only users that were let in do something");
  return static_cast<Role>(user - kFirstUser);
}

std::size_t open_descriptors() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

/// Passes by steps, and by a nap of whoever waits for the tick, which then comes.
class StepClock final : public loop::Clock {
 public:
  std::int64_t now_ns() override { return now_; }
  void sleep_until_ns(std::int64_t when_ns) override {
    std::int64_t now = now_;
    while (now < when_ns && !now_.compare_exchange_weak(now, when_ns)) {
    }
    if (tick) tick();
  }
  void pass(std::int64_t ns) { now_ += ns; }

  std::function<void()> tick;

 private:
  std::atomic<std::int64_t> now_{1'000'000'000};
};

/// The other end of one connection.
struct Client {
  int socket = -1;
  Role role = Role::kNone;
  bool reads = true;
  std::uint64_t sent = 0;  ///< bytes of the upload that it sends
  std::size_t which = 0;   ///< ball that it sends
  std::vector<std::uint8_t> unread;
  std::vector<Kind> heard;  ///< but for records
  bool was_closed = false;
};

class World {
 public:
  World(const std::uint8_t* data, std::size_t size)
      : front_(data, size),
        slots_(kImageLimit),
        store_(folder_, 4),
        intake_(slots_, &store_, clock_, [](const FieldView& field) { return check(field); }),
        measured_(folder_),
        calibration_(
            &measured_, nullptr, [](const std::string&) { return Calibration::Choice{libnifalcon_model()}; }, "A1", [](bool) {}),
        ring_(kRing) {
    calibration_.answers("A1");
    clock_.tick = [this] {
      if (!rests_) tick();
    };
    settings_.path = "/tmp/isotouch-fuzz-" + std::to_string(::getpid());
    settings_.program = "fuzz";
    settings_.recordings.device = libnifalcon_model();
    settings_.recordings.period_ns = 1'000'000;
    settings_.clients = kPlaces;
    settings_.admission.watch.users = {kFirstUser + 1};
    settings_.admission.operate.users = {kFirstUser + 2};
    settings_.admission.service.users = {kFirstUser + 3};
    settings_.peer = [this](int) {
      fuzz::hold(!knocking_.empty(), "nobody is let in who has not connected");
      const Peer peer{true, knocking_.front(), {}};
      knocking_.pop_front();
      return peer;
    };
    settings_.poll = [this](std::span<pollfd> polled, int) { return poll(polled); };
  }

  void run() {
    ControlServer server(settings_, {intake_, requests_, stats_, shown_, clock_, &ring_, &calibration_,
                                     [](std::string_view, std::string_view value, std::uint32_t author, bool may_raise) {
                                       const Role role = role_of_user(user_of(author));
                                       fuzz::hold(role >= kOperate, "whoever sets a setting has the role to operate");
                                       fuzz::hold(may_raise == (role >= kService), "only whoever has the role of service raises limits");
                                       return value == "no" ? Refusal("that cannot be; choose another value") : Refusal();
                                     },
                                     [] { return std::string("feel.friction = 0.5\n"); }, [this](const std::string& line) { log(line); }});
    fuzz::hold(!server.start(), "the server listens");
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return has_ended_.load(); });
    lock.unlock();
    server.stop();
    for (Client& client : clients_) hang_up(client);
  }

 private:
  // ---- what the server asks for ----

  /// Events that are there; where there are none the world goes one step on.
  int poll(std::span<pollfd> polled) {
    if (has_ended_) return ::poll(polled.data(), polled.size(), 1);
    bool waits = false;  // a client that is not read waits for the worker, a measurement, or its own reading
    for (std::size_t i = 3; i < polled.size(); ++i) waits |= (polled[i].events & POLLIN) == 0;
    // Whatever the worker still does takes real time, more on a busy machine.
    const int wait_ms = is_awaited() || (waits && ++naps_ < 3) ? 1 : 0;
    const int events = ::poll(polled.data(), polled.size(), wait_ms);
    for (Client& client : clients_)
      if (client.reads) hear(client);
    if (events > 0 && ++rounds_ < 500) return events;
    naps_ = rounds_ = 0;
    step();
    return ::poll(polled.data(), polled.size(), 0);
  }

  /// Is something to come that must come?
  bool is_awaited() const { return stop_by_.socket >= 0 || closing_ > 5; }

  static Refusal check(const FieldView& field) {
    return field.hash() == ball(kRefusedBall).promise.image_hash ? Refusal("this field is too stiff; build it again") : Refusal();
  }

  /// Each change names its author.
  void log(const std::string& line) {
    unsigned long long user = 0;
    int end = 0;
    fuzz::hold(std::sscanf(line.c_str(), "user %llu: %n", &user, &end) == 1 && end > 0, "a change names its author");
    const std::string what = line.substr(static_cast<std::size_t>(end));
    const Role wanted = what == "stop" ? kWatch : what.starts_with("other angles") ? kService : kOperate;
    fuzz::hold(role_of_user(user) >= wanted, "a change is made by somebody who may");
  }

  /// One tick, of the server's thread or the worker's.
  void tick() {
    const std::lock_guard lock(ticking_);
    const loop::ActiveField field = slots_.field();
    if (field.generation != generation_ && field.view != nullptr) {
      const std::uint64_t felt = hash64(field.view->image.data(), field.view->image.size());
      const std::uint64_t refused = ball(kRefusedBall).promise.image_hash;
      fuzz::hold(felt != refused, "a field that this device must not render is never felt");
      fuzz::hold(sent_whole_.count(felt) == 1, "a field that is felt was sent whole");
      fuzz::hold(role_of_user(user_of(field.author)) >= kOperate, "a field that is felt comes from somebody who operates");
    }
    generation_ = field.generation;
    const loop::Asked asked = requests_.take();
    if ((asked.bits & ~kRequestStop) != 0) fuzz::hold(role_of_user(user_of(asked.author)) >= kWatch, "a request has its author");
    obeyed_ |= asked.bits;
    loop::TickRecord record;
    record.number = ++ticks_;
    record.arrival_ns = clock_.now_ns();
    record.in.packet = encode(FalconReply{{count_, count_, count_}, 0, 7});
    record.in.fresh = true;
    record.in.requests = asked.bits;
    record.in.field_generation = field.generation;
    record.faults = record.out.faults = faults_;
    record.out.state = static_cast<std::uint16_t>(field.view != nullptr ? SupervisorState::kActive : SupervisorState::kIdle);
    stats_.ticks.add();
    shown_.put(record);
    ring_.push(record);
  }

  // ---- what the world does ----

  void step() {
    if (stops_) return go_on_with_the_stop();
    if (closing_ > 0) return close_down();
    if (front_.empty() || ++steps_ > 200) {
      closing_ = 1;
      return;
    }
    const auto what = front_.take<std::uint8_t>();
    Client& client = clients_[what % kClients];
    const auto more = front_.take<std::uint8_t>();
    switch (what / kClients % 16) {
      case 0: return hang_up(client), connect(client, static_cast<Role>(more % 4));
      case 1: return hang_up(client);
      case 2:
        return say(client, Kind::kHello,
                   protocol::Hello{static_cast<std::uint16_t>(more < 250 ? protocol::kMajor : more), protocol::kMinor});
      case 3: return say(client, static_cast<Kind>(more < 200 ? more % 24 : more));
      case 4: return begin(client, more);
      case 5: return send_chunk(client, more);
      case 6: return upload(client, more);
      case 7: return say(client, Kind::kSelect, protocol::Select{more < 250 ? ball(more).promise.image_hash : more});
      case 8:
        return say(client, Kind::kSet, protocol::Set{protocol::Text::of("friction"), protocol::Text::of(more % 2 == 0 ? "no" : "0.5")});
      case 9: return say_anything(client, static_cast<Kind>(more));
      case 10: return clock_.pass(std::int64_t{1'000'000} << more % 16);
      case 11:
        count_ = more % 16 == 0 ? static_cast<std::int16_t>(more) : count_;
        for (int i = 0; i < (more % 8 == 0 ? 1100 : more); ++i) tick();
        return;
      case 12: return world_fails(more);
      case 13: client.reads = more % 2 == 0; return;
      case 14:
        if (more % 4 == 1) return say(client, Kind::kReadImage, protocol::ReadImage{more / 32 * std::uint64_t{500}, 500});
        return say(client, Kind::kSubscribe, protocol::Subscribe{more < 250 ? more : 0xFFFFFFFFU});
      case 15: return more % 2 == 0 ? begin_a_stop() : calibrate(client, more);
    }
  }

  void world_fails(std::uint8_t how) {
    switch (how % 4) {
      case 0: rests_ = (how & 4) != 0; return;
      case 1: folder_.full = (how & 4) != 0; return;
      case 2: faults_ = (how & 4) != 0 ? static_cast<std::uint16_t>(1U << how / 16) : std::uint16_t{0}; return;
      case 3: (how & 4) != 0 ? take_descriptors() : give_descriptors(); return;
    }
  }

  /// One more can be opened: whoever connects takes it, and the server has none to let it in.
  void take_descriptors() {
    give_descriptors();
    const int next = ::dup(0);
    ::close(next);
    getrlimit(RLIMIT_NOFILE, &had_);
    rlimit now = had_;
    now.rlim_cur = static_cast<rlim_t>(next) + 1;
    setrlimit(RLIMIT_NOFILE, &now);
    taken_ = true;
  }
  void give_descriptors() {
    if (std::exchange(taken_, false)) setrlimit(RLIMIT_NOFILE, &had_);
  }

  /// Does nothing where too many wait to be let in, or no descriptor is left.
  void connect(Client& client, Role role) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(settings_.path.begin(), settings_.path.end(), address.sun_path);
    client.socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (client.socket < 0) return;
    if (::connect(client.socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return hang_up(client);
    client.role = role;
    knocking_.push_back(kFirstUser + static_cast<uid_t>(role));
  }

  static void hang_up(Client& client) {
    if (client.socket >= 0) ::close(client.socket);
    client = {};
  }

  void send(Client& client, std::span<const std::uint8_t> bytes) {
    if (client.socket < 0 || client.was_closed) return;
    const ssize_t taken = ::send(client.socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    // A server that takes no more has half a message: what would follow is no message of the protocol, and that is tried elsewhere.
    if (taken != static_cast<ssize_t>(bytes.size())) hang_up(client);
  }
  template <class Message>
  void say(Client& client, Kind kind, const Message& message) {
    std::vector<std::uint8_t> frame(protocol::kMaxFrame);
    frame.resize(protocol::encode(kind, message, frame));
    send(client, frame);
  }
  void say(Client& client, Kind kind) {
    std::array<std::uint8_t, protocol::kHeaderBytes> frame{};
    protocol::seal_frame(kind, 0, frame);
    send(client, frame);
  }
  /// A message of any content, or bytes that are none.
  void say_anything(Client& client, Kind kind) {
    std::vector<std::uint8_t> frame(protocol::kHeaderBytes + front_.take<std::uint8_t>() % 64);
    for (auto& byte : std::span(frame).subspan(protocol::kHeaderBytes)) byte = front_.take<std::uint8_t>();
    protocol::seal_frame(kind, frame.size() - protocol::kHeaderBytes, frame);
    const auto damage = front_.take<std::uint8_t>();
    if (damage >= 224) frame[damage % frame.size()] ^= 1;
    if (damage >= 192 && damage < 224) frame.resize(damage % frame.size());
    send(client, frame);
  }

  void begin(Client& client, std::uint8_t how) {
    protocol::Begin promise = ball(how % kBalls).promise;
    if (how >= 240) promise.image_hash ^= 1;
    if (how >= 224 && how < 240) promise.packed_bytes += how % 2 == 0 ? ~std::uint64_t{0} : 1;
    if (how >= 208 && how < 224) promise.image_bytes = how % 2 == 0 ? ~std::uint64_t{0} : promise.image_bytes + 4;
    client.which = how % kBalls;
    client.sent = 0;
    say(client, Kind::kBegin, promise);
  }
  void send_chunk(Client& client, std::uint8_t how) {
    const std::vector<std::uint8_t>& bytes = ball(client.which).bytes;
    const std::size_t at = std::min<std::size_t>(client.sent, bytes.size());
    std::vector<std::uint8_t> piece(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                                    bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at + kChunk, bytes.size())));
    if (how >= 240 && !piece.empty()) piece[how % piece.size()] ^= static_cast<std::uint8_t>(1U << how % 8);
    say(client, Kind::kChunk, protocol::Chunk{how >= 224 && how < 240 ? client.sent + 1 : client.sent, piece});
    client.sent += piece.size();
    // From here on it may be felt: all of it was sent, if all before was right. That it was is for the checksum to see.
    const std::lock_guard lock(ticking_);
    if (client.sent == bytes.size() && client.role >= kOperate) sent_whole_.insert(ball(client.which).promise.image_hash);
  }
  void upload(Client& client, std::uint8_t how) {
    begin(client, how);
    for (std::size_t at = 0; at < ball(client.which).bytes.size(); at += kChunk) send_chunk(client, 0);
    say(client, Kind::kCommit);
  }
  void calibrate(Client& client, std::uint8_t how) {
    protocol::Calibrate measured;
    measured.serial = protocol::Text::of(how % 4 == 1 ? "A1" : "B2");
    for (std::size_t i = 0; i < measured.at_zero.size(); ++i)
      measured.at_zero[i] = libnifalcon_model().legs[i].at_zero.raw() + (how >= 128 ? how * 100'000 : how);
    say(client, Kind::kCalibrate, measured);
  }

  /// Everything that has come. Each frame is one of the protocol; records are not kept.
  void hear(Client& client) {
    if (client.socket < 0 || client.was_closed) return;
    std::array<std::uint8_t, 1 << 14> bytes;
    for (;;) {
      const ssize_t got = ::recv(client.socket, bytes.data(), bytes.size(), 0);
      client.was_closed = got == 0 || (got < 0 && errno != EAGAIN);
      if (got <= 0) break;
      client.unread.insert(client.unread.end(), bytes.begin(), bytes.begin() + got);
    }
    std::size_t at = 0;
    for (;;) {
      const Result<protocol::Frame> frame = protocol::read_frame(std::span(client.unread).subspan(at));
      fuzz::hold(static_cast<bool>(frame), "what the server says is of the protocol");
      if (frame->size == 0) break;
      at += frame->size;
      understand(client, *frame);
    }
    client.unread.erase(client.unread.begin(), client.unread.begin() + static_cast<std::ptrdiff_t>(at));
  }
  static void understand(Client& client, const protocol::Frame& frame) {
    fuzz::hold(frame.kind >= Kind::kDone, "a server answers and does not ask");
    fuzz::hold(client.role != Role::kNone || frame.kind == Kind::kRefused, "whoever has no role hears why, and nothing else");
    fuzz::hold(frame.kind != Kind::kRecording || client.role >= kOperate, "only whoever operates records");
    fuzz::hold(frame.kind != Kind::kAccepted || client.role >= kOperate, "only whoever operates changes the field");
    fuzz::hold(frame.kind != Kind::kPostureReport || client.role >= kService, "only whoever has the role of service measures");
    if (frame.kind == Kind::kRefused) {
      const auto said = protocol::decode<protocol::Refusal>(frame.body);
      fuzz::hold(said && std::string(said->sentence.begin(), said->sentence.end()).find("; ") != std::string::npos,
                 "a refusal says what to do");
    }
    if (frame.kind != Kind::kRecords) client.heard.push_back(frame.kind);
  }

  // ---- a stop, whatever else goes on ----

  void begin_a_stop() {
    give_descriptors();
    clock_.pass(300'000'000);  // a server that had no descriptor listens again
    stops_ = true;
    stop_rounds_ = 0;
  }
  void go_on_with_the_stop() {
    clock_.pass(10'000'000);    // whoever has the place for a stop keeps it for its turn
    if (stop_by_.socket < 0) {  // where too many wait to be let in, a moment later
      connect(stop_by_, kWatch);
      fuzz::hold(++stop_rounds_ < kMaxRounds, "whoever wants to stop is let in");
      stops_before_ = requests_.stops();
      {
        const std::lock_guard lock(ticking_);
        obeyed_ = 0;
      }
      say(stop_by_, Kind::kHello, protocol::Hello{});
      return say(stop_by_, Kind::kStop);
    }
    hear(stop_by_);
    if (stop_by_.heard.size() < 2 && ++stop_rounds_ < kMaxRounds) return;
    fuzz::hold(stop_by_.heard == std::vector{Kind::kWelcome, Kind::kDone}, "a stop is always possible");
    fuzz::hold(requests_.stops() > stops_before_, "a stop that is answered was asked for");
    tick();
    fuzz::hold((obeyed_ & kRequestStop) != 0, "the next tick stops");
    hang_up(stop_by_);
    stops_ = false;
  }

  // ---- the end: everything is free again ----

  void close_down() {
    Client& last = clients_[0];
    switch (closing_++) {
      case 1: return begin_a_stop();
      case 2:
        for (Client& client : clients_) hang_up(client);
        rests_ = folder_.full = false;
        faults_ = 0;
        return;
      case 3: return tick();
      case 4: return;  // what was under way ends
      case 5:
        for (std::size_t i = 0; i < kPlaces; ++i) {
          connect(clients_[i], kService);
          say(clients_[i], Kind::kHello, protocol::Hello{});
        }
        say(last, Kind::kBegin, ball(0).promise);
        say(last, Kind::kResume);
        say(last, Kind::kRecord);
        return;
      default: break;
    }
    if ((clients_[1].heard.empty() || last.heard.size() < 4) && closing_ < kMaxRounds) return;
    for (std::size_t i = 0; i < kPlaces; ++i)
      fuzz::hold(!clients_[i].heard.empty() && clients_[i].heard[0] == Kind::kWelcome, "every place is free again");
    fuzz::hold(last.heard.size() == 4 && last.heard[1] == Kind::kDone, "an upload may begin");
    fuzz::hold(last.heard[2] == (calibration_.others() != protocol::OtherAngles::kNone ? Kind::kRefused : Kind::kDone),
               "a fault may be resumed: nobody is being measured, and the device has the angles in use");
    fuzz::hold(last.heard[3] == Kind::kRecording, "a recording may begin");
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_one();
  }

  fuzz::Front front_;
  StepClock clock_;
  store::CrashingFolder folder_;
  loop::FieldSlots slots_;
  store::FieldStore store_;
  store::FieldIntake intake_;
  store::CalibrationStore measured_;
  Calibration calibration_;
  loop::Requests requests_;
  loop::TickStats stats_;
  loop::Latest<loop::TickRecord> shown_;
  loop::TraceRing ring_;
  ControlSettings settings_;

  std::mutex ticking_;  // of what follows
  std::uint64_t ticks_ = 0;
  std::uint32_t generation_ = 0;
  std::uint8_t obeyed_ = 0;
  std::atomic<bool> rests_{false};
  std::uint16_t faults_ = 0;
  std::int16_t count_ = 0;

  std::deque<uid_t> knocking_;  ///< who has connected and was not let in yet
  std::array<Client, kClients> clients_;
  Client stop_by_;
  std::set<std::uint64_t> sent_whole_;
  rlimit had_{};
  bool taken_ = false, stops_ = false;
  std::uint32_t stops_before_ = 0;
  int naps_ = 0, rounds_ = 0, steps_ = 0, stop_rounds_ = 0, closing_ = 0;

  std::mutex mutex_;  // of what follows
  std::condition_variable ended_;
  std::atomic<bool> has_ended_{false};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)ball(0);
  const std::size_t before = open_descriptors();
  World(data, size).run();
  fuzz::hold(open_descriptors() == before, "every descriptor is closed again");
  return 0;
}
