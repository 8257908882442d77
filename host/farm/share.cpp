#include "host/farm/share.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "host/error.h"
#include "host/farm/answer.h"

namespace isotouch::farm {

ShareReport run_share(const std::vector<Recording>& recordings, const std::vector<Program>& programs, const std::filesystem::path& answers,
                      const Share& share) {
  std::error_code error;
  std::filesystem::create_directories(answers, error);
  if (error || ::access(answers.c_str(), W_OK) != 0)
    throw InputError(answers.string() + ": cannot be written as a folder; name another folder for the answers");
  const std::size_t tasks = recordings.size() * programs.size(), shards = std::min(share.shards, tasks);
  std::atomic<std::size_t> next = share.shard < shards ? 0 : tasks;
  std::mutex counting;
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
        const bool is_kept = before && before->outcome != Answer::Outcome::kFailed;
        const Answer answer = is_kept ? *before : ask(recording, program, share.patience);
        if (!is_kept) keep(answers, recording, program, answer);
        const std::lock_guard lock(counting);
        ++report.tasks;
        ++(is_kept ? report.kept : report.asked);
        if (answer.outcome == Answer::Outcome::kFailed) ++report.failed;
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
