#include "host/farm/share.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "host/farm/answer.h"

namespace isotouch::farm {

ShareReport run_share(const std::vector<Recording>& recordings, const std::vector<Program>& programs, const std::filesystem::path& answers,
                      const Share& share, const std::function<bool()>& may_go_on) {
  std::atomic<std::size_t> next = share.shard;
  std::mutex counting;
  ShareReport report;
  std::exception_ptr broken;
  const auto work = [&] {
    try {
      while (may_go_on()) {
        const std::size_t task = next.fetch_add(share.shards);
        if (task >= recordings.size() * programs.size()) return;
        const Recording& recording = recordings[task / programs.size()];
        const Program& program = programs[task % programs.size()];
        const std::optional<Answer> before = kept_answer(answers, address_of(recording, program));
        const bool is_kept = before && before->outcome != Answer::Outcome::kFailed;
        const Answer answer = is_kept ? *before : ask(recording, program);
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
