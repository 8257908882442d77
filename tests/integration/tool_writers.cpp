/// What the host tool writes: a file, and a farm's answers.
#include "host/farm/answer.h"
#include "host/files/whole_file.h"
#include "tests/integration/killed_writers.h"

namespace isotouch::test {
namespace {

/// Bytes that say which write they are of, and are long enough for several pages.
std::vector<std::uint8_t> bytes_of(Number number) {
  std::vector<std::uint8_t> bytes(20'000 + number % 100 * 1000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>((number >> i % 8 * 8) & 0xFF);
  return bytes;
}

class ToolFiles final : public Kind {
 public:
  using Kind::Kind;
  fs::path path() const { return folder() / "out.itf"; }
  void write(Number first, const Reporter& report) override {
    for (Number number = first;; ++number) {
      const auto bytes = bytes_of(number);
      report.begin(number);
      write_file(path(), bytes.data(), bytes.size());
      report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    if (!fs::exists(path())) return 0;
    const auto bytes = read_file(path());
    Number number = 0;
    for (std::size_t i = 0; i < 8 && i < bytes.size(); ++i) number |= Number{bytes[i]} << 8 * i;
    if (bytes != bytes_of(number)) wrong = "a file of the tool is not whole";
    return number;
  }
};

class Answers final : public Kind {
 public:
  using Kind::Kind;
  void write(Number first, const Reporter& report) override {
    for (Number number = first;; ++number) {
      farm::Answer answer{farm::Answer::Outcome::kEqual, number, 1, recording_.expected, {}, {}, {}};
      report.begin(number);
      farm::keep(folder(), recording_, program_, answer);
      report.done(number);
    }
  }
  Number found(Verdict& wrong) override {
    const std::string address = farm::address_of(recording_, program_);
    const fs::path file = folder() / address.substr(0, 2) / (address.substr(2) + ".json");
    const auto answer = farm::kept_answer(folder(), recording_, program_);
    if (!answer && fs::exists(file)) wrong = "a kept answer is none";
    return answer ? answer->ticks : 0;
  }

 private:
  farm::Recording recording_{"a", {"a.itf", "0"}, {"a.trace", "0"}, {}, "0123456789abcdef", "device", "origin"};
  farm::Program program_{"x86-64", "1", "gcc", "0", {"./program"}, "0", {}};
};

}  // namespace

std::vector<NamedKind> tool_writers() { return {named<ToolFiles>("tool-files"), named<Answers>("farm-answers")}; }

}  // namespace isotouch::test
