#include "host/qualify/finding.h"

namespace isotouch::qualify {

const std::string* Board::text(const std::string& path) const {
  const auto found = files_.texts.find(path);
  return found == files_.texts.end() ? nullptr : &found->second;
}

std::vector<std::pair<std::string, std::string>> Board::under(const std::string& begin, const std::string& end) const {
  std::vector<std::pair<std::string, std::string>> found;
  for (auto at = files_.texts.lower_bound(begin); at != files_.texts.end() && at->first.starts_with(begin); ++at) {
    if (at->first.size() >= begin.size() + end.size() && at->first.ends_with(end)) found.emplace_back(*at);
  }
  return found;
}

std::optional<Scheduling> Board::thread(const std::string& name) const {
  const std::string* stat = text("thread/" + name + "/stat");
  return stat == nullptr ? std::nullopt : scheduling(*stat);
}

std::optional<std::set<int>> Board::cores(const std::string& name) const {
  const std::string* list = text("thread/" + name + "/cores");
  const auto cores = list == nullptr ? std::nullopt : processors(*list);
  return cores && !cores->empty() ? cores : std::nullopt;
}

std::optional<std::set<int>> Board::online() const {
  const std::string* list = text("/sys/devices/system/cpu/online");
  return list == nullptr ? std::nullopt : processors(*list);
}

int Board::best_core() const {
  const auto all = online();
  return all && !all->empty() ? *all->rbegin() : 0;
}

bool Board::may_run_threads(int core) const {
  bool known = false;
  for (const char* name : {"tick", "exchange", "watchdog"}) {
    const auto allowed = cores(name);
    if (allowed && allowed->count(core) != 0) return true;
    known = known || allowed;
  }
  return !known;
}

Finding Ask::not_read(const Board& board, const std::string& path) const {
  if (board.is_missing(path))
    return not_known("There is no " + path + " on this machine.",
                     "On a container or a virtual machine there is nothing to do here; a board's kernel has this file.");
  return not_known("This user may not read " + path + ".", "Measure as a user who may, such as root: --to ssh://root@board");
}

Finding Ask::garbled_file(const std::string& path, const std::string& text) const { return garbled(text, "See it with: cat " + path); }

Finding Ask::garbled(const std::string& text, const std::string& remedy) const {
  Finding finding = not_known("The content is not of the expected form.", remedy);
  finding.read = shown(text);
  return finding;
}

Finding Ask::no_controller(const std::string& read) const {
  Finding finding = not_known("No thread 'tick' of a controller is seen on this machine.",
                              "Measure on the machine where the controller runs, as a user who may see its processes.");
  finding.read = read;
  return finding;
}

}  // namespace isotouch::qualify
