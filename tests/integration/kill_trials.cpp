/// Kills a writer at a random moment, again and again, and looks at what it leaves: kill_trials FOLDER KILLS [SEED [KIND...]]
///
/// A child writes one thing after the other and says on a pipe what it begins and what has been acknowledged. The parent kills it, opens what is there with
/// fresh objects, and checks: nothing acknowledged is lost, nothing is half-written, the next start is clean, and the folder does not grow. Every second
/// child rests behind its last write, so that only that one may be there. A kind fails, too, if hardly any kill fell into a write, or between two.
///
/// A kill loses nothing that was handed to the kernel. What a power cut loses is tried in tests/firmware/store.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "host/error.h"
#include "tests/integration/killed_writers.h"

namespace isotouch::test {
namespace {

/// Sleeps, so that the child works on even where there is one processor for both.
void wait(std::chrono::microseconds time) {
  ::prctl(PR_SET_TIMERSLACK, 1);  // nanoseconds; 50 us otherwise, longer than some writes
  std::this_thread::sleep_for(time);
}

/// One child, killed after some acknowledged writes and a part of another one; one that rests does not begin another one.
Heard kill_one(Kind& kind, Number first, bool rests, std::mt19937_64& random, double& write_us) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError("no pipe can be made; free some descriptors");
  const Number wanted = rests ? 1 + random() % 3 : random() % 4;
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::close(ends[0]);
    kind.write(first, Reporter(ends[1], rests ? wanted : 0));
    ::_exit(1);
  }
  ::close(ends[1]);
  Heard heard;
  const auto take = [&](Number word) { ((word & 1) != 0 ? heard.done : heard.begun) = word >> 1; };
  unsigned refused = 0;
  Number word = 0;
  auto begun = std::chrono::steady_clock::now();
  for (Number got = 0; got < wanted && ::read(ends[0], &word, sizeof word) == sizeof word;) {
    take(word);
    const auto now = std::chrono::steady_clock::now();
    if ((word & 1) == 0) {
      if (++refused > 100) throw InputError("a hundred writes were begun and none was acknowledged; see what the writer refuses");
      begun = now;
      continue;
    }
    refused = 0;
    ++got;
    write_us += 0.1 * (std::chrono::duration<double, std::micro>(now - begun).count() - write_us);
  }
  wait(std::chrono::microseconds(static_cast<std::int64_t>(static_cast<double>(random() % 1000) / 1000 * 1.5 * std::min(write_us, 1e6))));
  ::kill(child, SIGKILL);
  while (::read(ends[0], &word, sizeof word) == sizeof word) take(word);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGKILL) throw InputError("a child has ended by itself: it cannot write");
  return heard;
}

/// returns   everything holds
bool try_kind(const NamedKind& named, const fs::path& folder, unsigned kills, std::uint64_t seed) {
  fs::remove_all(folder / named.name);
  const std::unique_ptr<Kind> kind = named.make(folder / named.name);
  std::mt19937_64 random(seed);
  Number last = 0;
  unsigned within = 0;
  double write_us = 300;
  std::size_t files_early = 0;
  for (unsigned n = 0; n < kills; ++n) {
    const Number first = last + 1;
    const Heard heard = kill_one(*kind, first, n % 2 == 1, random, write_us);
    if (kind->begins_anew()) last = 0;
    const Number done = std::max(heard.done, last), begun = std::max(heard.begun, done);
    within += begun > done ? 1 : 0;
    Verdict wrong;
    const Number found = kind->found(wrong);
    const auto is = [&](Number number) { return named.modulo == 0 ? found == number : found % named.modulo == number % named.modulo; };
    const bool none_yet = done == 0 && (found == 0 || (kind->begins_anew() && heard.begun == 0));
    if (wrong.empty() && !none_yet && !is(done) && !is(begun))
      wrong = "write " + std::to_string(done) + " was acknowledged and " + std::to_string(begun) + " begun, but " + std::to_string(found) +
              " is there";
    if (!wrong.empty()) {
      std::printf("%-13s kill %u of seed %llu: %s\n", named.name, n + 1, static_cast<unsigned long long>(seed), wrong.c_str());
      return false;
    }
    last = is(begun) ? begun : done;
    if (n == kills / 10) files_early = kind->files();
  }
  const std::size_t files = kind->files();
  std::printf("%-13s %u kills, %u of them within a write of about %.0f us, %zu files left\n", named.name, kills, within, write_us, files);
  if (files > files_early + 4)
    return std::printf("%-13s the folder grows: %zu files after a tenth of the kills, %zu now\n", named.name, files_early, files), false;
  if (kills - within < kills / 4) return std::printf("%-13s too few kills fell between writes: nothing is shown\n", named.name), false;
  if (within < kills / 20) return std::printf("%-13s too few kills fell within a write: nothing is shown\n", named.name), false;
  return true;
}

int run(const fs::path& folder, unsigned kills, std::uint64_t seed, const std::vector<std::string>& wanted) {
  std::vector<NamedKind> kinds = controller_writers();
  std::ranges::copy(tool_writers(), std::back_inserter(kinds));
  unsigned passed = 0, failed = 0;
  for (const NamedKind& kind : kinds) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), kind.name) == wanted.end()) continue;
    ++(try_kind(kind, folder, kills, seed) ? passed : failed);
    std::fflush(stdout);
  }
  std::printf("%u passed, %u failed, 0 skipped\n", passed, failed);
  return failed == 0 && passed > 0 ? 0 : 1;
}

}  // namespace
}  // namespace isotouch::test

int main(int argc, char** argv) try {
  if (argc < 3) return std::fprintf(stderr, "usage: kill_trials FOLDER KILLS [SEED [KIND...]]\n"), 2;
  const unsigned long kills = std::stoul(argv[2]);
  return isotouch::test::run(argv[1], static_cast<unsigned>(kills), argc > 3 ? std::stoull(argv[3]) : 1,
                             {argv + std::min(argc, 4), argv + argc});
} catch (const std::exception& error) {
  return std::fprintf(stderr, "kill_trials: %s\n", error.what()), 1;
}
