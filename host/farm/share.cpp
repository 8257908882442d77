#include "host/farm/share.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "host/error.h"
#include "host/farm/answer.h"

namespace isotouch::farm {
namespace {

/// The files of recordings, each read once.
class Unchanged {
 public:
  /// Why a recording's files are not those of the table; empty: they are. Any thread; only who wants the same file waits while it is read.
  std::string refusal_of(const Recording& recording) {
    std::string refusal;
    for (const NamedFile& file : files_of(recording)) {
      Seen& seen = seen_of(file);
      std::call_once(seen.once, [&] { seen.refusal = look(file); });
      if (refusal.empty()) refusal = seen.refusal;
    }
    return refusal;
  }

 private:
  struct Seen {
    std::once_flag once;
    std::string refusal;
  };

  Seen& seen_of(const NamedFile& file) {
    const std::lock_guard lock(mutex_);
    return seen_[{file.path, file.hash}];
  }
  static std::string look(const NamedFile& file) {
    try {
      require_same(file);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  }

  std::mutex mutex_;
  std::map<std::pair<std::filesystem::path, std::string>, Seen> seen_;
};

}  // namespace

ShareReport run_share(const std::vector<Recording>& recordings, const std::vector<Program>& programs, const std::filesystem::path& answers,
                      const Share& share) {
  std::error_code error;
  std::filesystem::create_directories(answers, error);
  if (error || ::access(answers.c_str(), W_OK) != 0)
    throw InputError(answers.string() + ": cannot be written as a folder; name another folder for the answers");
  const std::size_t tasks = recordings.size() * programs.size(), shards = std::min(share.shards, tasks);
  std::atomic<std::size_t> next = share.shard < shards ? 0 : tasks;
  std::mutex counting;
  Unchanged files;
  ShareReport report;
  std::exception_ptr broken;
  const auto work = [&] {
    try {
      while (share.patience.may_go_on()) {
        const std::size_t round = next.fetch_add(1), task = round * shards + (share.shard + round) % shards;
        if (round * shards >= tasks) return;
        if (task >= tasks) continue;  // the last run is shorter
        const Recording& recording = recordings[task / programs.size()];
        const Program& program = programs[task % programs.size()];
        const std::optional<Answer> before = kept_answer(answers, recording, program);
        const std::string changed = files.refusal_of(recording);
        const bool is_kept = before && before->outcome != Answer::Outcome::kFailed;
        const Answer answer = is_kept ? *before : ask(recording, program, share.patience);
        if (!is_kept) keep(answers, recording, program, answer);
        const std::lock_guard lock(counting);
        ++report.tasks;
        ++(is_kept ? report.kept : report.asked);
        if (answer.outcome == Answer::Outcome::kFailed || !changed.empty()) ++report.failed;
        if (report.changed.empty()) report.changed = changed;
      }
    } catch (...) {
      const std::lock_guard lock(counting);
      broken = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  for (unsigned job = 1; job < share.jobs; ++job) others.emplace_back(work);
  work();
  others.clear();
  if (broken) std::rethrow_exception(broken);
  return report;
}

}  // namespace isotouch::farm
