#include "firmware/daemon/printer.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): signal
#include <unistd.h>

#include <chrono>
#include <memory>
#include <sstream>
#include <string>

namespace isotouch::daemon {
namespace {

using namespace std::chrono_literals;

/// Stays open at its writing end: a printer's thread may be left behind there.
struct Pipe {
  Pipe() { EXPECT_EQ(pipe(ends), 0); }

  /// What is there until nothing came for a while.
  std::string read_all() const {
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    std::string text, piece(4096, '\0');
    for (int empty = 0; empty < 200;) {
      const ssize_t bytes = read(ends[0], piece.data(), piece.size());
      if (bytes > 0) text.append(piece, 0, static_cast<std::size_t>(bytes));
      empty = bytes > 0 ? 0 : empty + 1;
      if (bytes <= 0) usleep(1000);
    }
    return text;
  }

  int ends[2] = {-1, -1};
};

TEST(Printer, EverythingIsWrittenInItsOrderBeforeItEnds) {
  const Pipe pipe;
  std::string expected;
  {
    Printer printer(pipe.ends[1]);
    for (int i = 0; i < 1000; ++i) {
      printer.say(std::to_string(i));
      expected += std::to_string(i) + "\n";
    }
  }
  EXPECT_EQ(pipe.read_all(), expected);
}

TEST(Printer, WhereNobodyReadsNobodyWaitsAndWhatWasLeftOutIsCounted) {
  const Pipe pipe;
  const std::string text(999, 'x');
  auto printer = std::make_unique<Printer>(pipe.ends[1]);
  constexpr std::size_t kTexts = 1000;
  for (std::size_t i = 0; i < kTexts; ++i) printer->say(text);
  std::istringstream written(pipe.read_all());
  std::size_t texts = 0, left_out = 0;
  for (std::string line; std::getline(written, line);) {
    std::size_t digits = 0;
    if (line == text) {
      ++texts;
    } else {
      left_out += std::stoul(line, &digits);
      EXPECT_EQ(line.substr(digits), " messages were left out, because nobody read the output");
    }
  }
  EXPECT_EQ(texts + left_out, kTexts);
  EXPECT_GT(left_out, 0U);
  EXPECT_GE(texts, Printer::kRoom / 1000);
  printer->say("again");
  EXPECT_EQ(pipe.read_all(), "again\n");
}

TEST(Printer, ItsEndWaitsForNoReader) {
  const Pipe pipe;
  auto printer = std::make_unique<Printer>(pipe.ends[1]);
  for (int i = 0; i < 1000; ++i) printer->say(std::string(999, 'x'));
  const auto begin = std::chrono::steady_clock::now();
  printer.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 30s) << "half a second, and a busy machine";
}

TEST(Printer, WhereNobodyCanReadItEnds) {
  const Pipe pipe;
  close(pipe.ends[0]);
  signal(SIGPIPE, SIG_IGN);
  Printer(pipe.ends[1]).say("to nobody");
}

}  // namespace
}  // namespace isotouch::daemon
