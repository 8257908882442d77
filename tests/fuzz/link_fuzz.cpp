/// The door for a controller's answers: the other end of the control socket says anything, whatever the host tool and the C library ask of it. The first
/// byte says what is asked; the rest is what is answered, with the checksums that each message must have.
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "host/error.h"
#include "host/library/isotouch.h"
#include "host/link/controller.h"
#include "host/link/status.h"
#include "shared/protocol.h"
#include "tests/fuzz/input.h"
#include "tests/support/field_image.h"

using namespace isotouch;

namespace {

constexpr std::uint32_t kPatienceMs = 20'000;

/// Answers each connection with the same bytes, whatever it asks, and hangs up.
class Impostor {
 public:
  Impostor()
      : path_("/tmp/isotouch-fuzz-" + std::to_string(::getpid()) + ".sock"), socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(path_.begin(), path_.end(), address.sun_path);
    ::unlink(path_.c_str());
    fuzz::hold(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 && ::listen(socket_, 16) == 0,
               "it listens");
    std::thread([this] {
      for (;;) serve();
    }).detach();
  }

  std::string address() const { return "unix:" + path_; }
  void says(std::vector<std::uint8_t> bytes) {
    const std::lock_guard lock(mutex_);
    bytes_ = std::move(bytes);
  }

 private:
  /// Each connection in a thread of its own: whoever asks is never kept waiting by another one.
  void serve() {
    const int client = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0) return;
    {
      const std::lock_guard lock(mutex_);
      for (std::size_t sent = 0; sent < bytes_.size();) {
        const ssize_t taken = ::send(client, bytes_.data() + sent, bytes_.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (taken <= 0) break;  // more than a socket holds is not tried
        sent += static_cast<std::size_t>(taken);
      }
    }
    ::shutdown(client, SHUT_WR);
    std::thread([client] {
      std::array<std::uint8_t, 1 << 14> bytes;
      while (::recv(client, bytes.data(), bytes.size(), 0) > 0) {
      }
      ::close(client);
    }).detach();
  }

  std::string path_;
  int socket_;
  std::mutex mutex_;
  std::vector<std::uint8_t> bytes_;
};

/// Each frame gets its checksum; what does not look like one comes as it is.
std::vector<std::uint8_t> sealed(const std::uint8_t* data, std::size_t size) {
  using namespace protocol;
  std::vector<std::uint8_t> all(data, data + size);
  std::span<std::uint8_t> stream(all);
  while (stream.size() >= kHeaderBytes) {
    const auto body = std::min<std::size_t>(load_le<std::uint32_t>(stream.data() + kLengthAt), stream.size() - kHeaderBytes);
    stream = stream.subspan(seal_frame(static_cast<Kind>(stream[kKindAt]), std::min(body, kMaxBody), stream));
  }
  return all;
}

std::uint64_t ball() {
  static const std::uint64_t field = [] {
    const auto bytes = test::FieldImage({16, 16, 16},
                                        [](const test::Point& p) {
                                          return length(p - test::Point{8, 8, 8}) - 3;
                                        },
                                        {.band = 2})
                           .bytes();
    std::uint64_t made = 0;
    fuzz::hold(isotouch_field_read(bytes.data(), bytes.size(), &made) == ISOTOUCH_OK, "the ball is a field");
    return made;
  }();
  return field;
}

/// The requests of the host tool. They throw InputError, and nothing else.
void ask(std::uint8_t what, const std::string& address) try {
  link::Controller controller(address, static_cast<int>(kPatienceMs));
  const auto header = [](std::span<const std::uint8_t>) {};
  switch (what % 9) {
    case 0:
      static_cast<void>(link::to_json(link::whole_status(controller)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
      break;
    case 1:
      for (const auto& bin : controller.histogram(protocol::Measure{}).bins) static_cast<void>(bin);
      break;
    case 2: fuzz::hold(controller.fields().size() <= 0xFFFF, "a list is no longer than one frame"); break;
    case 3: static_cast<void>(controller.select(1)); break;
    case 4: {
      DeviceModel model;
      static_cast<void>(controller.posture(model));
      break;
    }
    case 5: controller.calibrate({}); break;
    case 6: static_cast<void>(controller.worst_ticks(true)); break;
    case 7: static_cast<void>(controller.record(5, header, header, [] { return false; })); break;
    case 8: static_cast<void>(controller.settings()); break;
  }
} catch (const InputError& error) {
  fuzz::hold(std::string_view(error.what()).find('\n') == std::string_view::npos, "what is wrong is said in one line");
}

/// The functions of C.
isotouch_status call(std::uint8_t what, std::uint64_t controller) {
  switch (what % 7) {
    case 0: {
      std::array<char, 4096> json;
      std::size_t needed = 0;
      return isotouch_controller_status(controller, json.data(), what < 128 ? json.size() : 1, &needed);
    }
    case 1: return isotouch_controller_set(controller, "friction", "0.3");
    case 2: return isotouch_controller_upload(controller, ball(), "ball");
    case 3: return isotouch_controller_stop(controller);
    case 4: return isotouch_controller_resume(controller);
    case 5: {
      std::uint64_t lost = 0;
      const auto on_tick = [](void*, const isotouch_felt* felt) {
        fuzz::hold(std::isfinite(felt->force_n[0]) && std::isfinite(felt->hip_mm[0]), "a tick that is shown has numbers");
        return felt->buttons == 9 ? 1 : 0;
      };
      return isotouch_controller_watch(controller, what, 5, on_tick, nullptr, &lost);
    }
    default: {
      static const std::string file = "/tmp/isotouch-fuzz-" + std::to_string(::getpid()) + ".trace";
      std::uint64_t recorded = 0;
      const isotouch_status status = isotouch_controller_record(controller, 5, file.c_str(), nullptr, nullptr, &recorded);
      fuzz::hold(!std::filesystem::exists(file + ".part"), "no recording is left half written");
      fuzz::hold(std::filesystem::exists(file) == (recorded > 0), "there is a recording where ticks were recorded");
      ::unlink(file.c_str());
      return status;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Impostor& impostor = *new Impostor;
  if (size < 1) return 0;
  impostor.says(sealed(data + 1, size - 1));
  if (data[0] % 2 == 0) {
    ask(data[0] / 2, impostor.address());
    return 0;
  }
  std::uint64_t controller = 0;
  isotouch_status status = isotouch_controller_connect(impostor.address().c_str(), kPatienceMs, &controller);
  for (int again = 0; status == ISOTOUCH_OK && again < 2; ++again) status = call(data[0] / 2, controller);
  fuzz::hold(status >= ISOTOUCH_OK && status <= ISOTOUCH_NO_MEMORY, "every call has a status that is no mistake of the library");
  fuzz::hold(status == ISOTOUCH_OK || isotouch_last_error()[0] != 0, "every failure has a sentence");
  isotouch_free(controller);
  return 0;
}
