/// The wires between the virtual board and the world outside: pulls the board's emergency stop, and writes down every edge of the stop, the enable, the
/// heartbeat and the light, in the order in which the board saw them.
///
/// usage     board_wires QMP QTEST      sockets of QEMU's monitor and of its test protocol
/// stdin     one command a line: "press", "release"
/// stdout    one line an edge, such as "enable high"; begins with "ready"
/// source    QEMU's docs/devel/qtest.rst and qmp-spec; the virt board's PL061, whose lines 0, 1, 2 and 4 a board's settings name
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace {

constexpr int kStop = 0, kEnable = 1, kHeartbeat = 2, kLight = 4;

/// A local socket, or standard input, line by line.
class Lines {
 public:
  explicit Lines(int descriptor) : descriptor_(descriptor) {}
  explicit Lines(const std::string& path) : descriptor_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    if (path.size() >= sizeof name.sun_path) throw std::runtime_error(path + ": too long for the path of a socket");
    std::copy(path.begin(), path.end(), name.sun_path);
    if (::connect(descriptor_, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) {
      throw std::runtime_error(path + ": nobody listens; give the socket of a running QEMU");
    }
  }

  int descriptor() const { return descriptor_; }

  void send(const std::string& line) const {
    const std::string text = line + "\n";
    if (::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(text.size()))
      std::exit(0);  // the board has ended
  }

  /// A whole line that has come; false: not yet.
  bool next(std::string& line) {
    const auto end = text_.find('\n');
    if (end == std::string::npos) return false;
    line = text_.substr(0, end);
    text_.erase(0, end + 1);
    if (line.ends_with('\r')) line.pop_back();
    return true;
  }

  /// Waits for more. Ends the program where there will be none.
  void wait() {
    char more[4096];
    const ssize_t size = ::read(descriptor_, more, sizeof more);
    if (size <= 0) std::exit(0);
    text_.append(more, static_cast<std::size_t>(size));
  }

  std::string await() {
    std::string line;
    while (!next(line)) wait();
    return line;
  }

 private:
  int descriptor_;
  std::string text_;
};

/// Where QEMU's object tree has the GPIO chip.
std::string chip_path(Lines& monitor) {
  (void)monitor.await();  // a greeting
  monitor.send(R"({"execute": "qmp_capabilities"})");
  monitor.send(R"({"execute": "qom-list", "arguments": {"path": "/machine/unattached"}})");
  for (;;) {
    const std::string line = monitor.await();
    const auto type = line.find("child<pl061>");
    const auto name = type == std::string::npos ? type : line.rfind("device[", type);
    if (name != std::string::npos) return "/machine/unattached/" + line.substr(name, line.find(']', name) + 1 - name);
    if (line.find("\"return\": [") != std::string::npos)
      throw std::runtime_error("this board has no PL061; take QEMU's virt board for arm64");
  }
}

void tell(int line, bool high) {
  const char* name = line == kStop        ? "stop"
                     : line == kEnable    ? "enable"
                     : line == kHeartbeat ? "heartbeat"
                     : line == kLight     ? "light"
                                          : nullptr;
  if (name == nullptr) return;
  std::printf("%s %s\n", name, high ? "high" : "low");
  std::fflush(stdout);
}

void run(const std::string& qmp, const std::string& qtest) {
  Lines monitor(qmp), board(qtest), people(STDIN_FILENO);
  const std::string chip = chip_path(monitor);
  board.send("irq_intercept_out " + chip);
  std::puts("ready");
  std::fflush(stdout);
  const auto pull = [&](bool high) {
    board.send("set_irq_in " + chip + " unnamed-gpio-in " + std::to_string(kStop) + (high ? " 1" : " 0"));
    tell(kStop, high);
  };
  for (std::string line;;) {
    while (board.next(line)) {
      int number = 0;
      if (std::sscanf(line.c_str(), "IRQ raise %d", &number) == 1) tell(number, true);
      if (std::sscanf(line.c_str(), "IRQ lower %d", &number) == 1) tell(number, false);
      if (line.starts_with("FAIL") || line.starts_with("ERR")) throw std::runtime_error("QEMU refused a wire: " + line);
    }
    while (people.next(line)) {
      if (line == "press") pull(false);
      if (line == "release") pull(true);
    }
    pollfd both[] = {{board.descriptor(), POLLIN, 0}, {people.descriptor(), POLLIN, 0}};
    if (::poll(both, 2, -1) < 0) continue;
    if (both[0].revents != 0) board.wait();
    if (both[1].revents != 0) people.wait();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: board_wires QMP QTEST\n");
    return 2;
  }
  try {
    run(argv[1], argv[2]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "board_wires: %s\n", e.what());
    return 1;
  }
}
