#include "host/stream/sources.h"

#include <exception>
#include <utility>

#include "host/cloud/read_cloud.h"
#include "host/field/parallel.h"
#include "host/files/whole_file.h"

namespace isotouch::stream {

Source files(std::vector<std::filesystem::path> files, std::optional<double> rate, const cloud::SensorOptions& sensor) {
  return [files = std::move(files), rate, sensor](Inbox& inbox) {
    const Clock::time_point begin = Clock::now();
    std::uint64_t number = 0;
    for (const std::filesystem::path& file : files) {
      Frame frame{++number,
                  [file, bytes = read_file(file), sensor]() mutable {
                    return cloud::read_frame({file, std::move(bytes), sensor});
                  },
                  {}};
      if (rate && !inbox.wait_until(begin + std::chrono::duration_cast<Clock::duration>(
                                                std::chrono::duration<double>(static_cast<double>(number - 1) / *rate)))) {
        return;
      }
      if (!(rate ? inbox.offer(std::move(frame)) : inbox.hand_over(std::move(frame)))) return;
    }
  };
}

std::jthread run(Source source, Inbox& inbox) {
  return std::jthread([source = std::move(source), &inbox, threads = field::ThreadLimit::threads()] {
    const field::ThreadLimit same(threads);
    try {
      source(inbox);
      inbox.finish();
    } catch (...) {
      inbox.finish(std::current_exception());
    }
  });
}

}  // namespace isotouch::stream
