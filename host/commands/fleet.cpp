/// isotouch fleet: the reports of many boards in one table.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/board_commands/output.h"
#include "host/commands/commands.h"
#include "host/files/whole_file.h"
#include "host/qualify/fleet.h"

namespace isotouch::commands {

namespace {

namespace fs = std::filesystem;

struct FleetOptions {
  std::vector<fs::path> reports;
  fs::path out;

  void operator()() const {
    const qualify::Fleet fleet = qualify::read_fleet(reports);
    if (!out.empty()) write_file(out, qualify::to_csv(fleet));
    print(text_stream(out), fleet);
    const auto unfit = std::ranges::count_if(fleet.boards, [](const qualify::FleetBoard& board) { return board.verdict != "fit"; });
    if (unfit > 0)
      throw ComparisonFailed("boards that are not fit: " + std::to_string(unfit) + " of " + std::to_string(fleet.boards.size()));
  }

 private:
  static void print(std::FILE* to, const qualify::Fleet& fleet) {
    for (const qualify::FleetBoard& board : fleet.boards) {
      std::fprintf(to, "%-24s %-20s %s\n", board.name.c_str(), board.date.c_str(), board.verdict.c_str());
      for (const std::string& key : board.outliers) {
        const auto at = static_cast<std::size_t>(std::ranges::find(fleet.keys, key) - fleet.keys.begin());
        std::fprintf(to, "%-24s   unlike the others: %s is %.6g\n", "", key.c_str(), *board.values[at]);
      }
    }
    for (const std::string& sentence : qualify::unlike_limits(fleet)) std::fprintf(to, "The limits differ: %s\n", sentence.c_str());
    if (fleet.unjudged.empty()) return;
    std::fprintf(to, "It takes %zu boards to say which is unlike the others; fewer have measured", qualify::kMinFleet);
    for (const std::string& key : fleet.unjudged) std::fprintf(to, " %s", key.c_str());
    std::fprintf(to, "\n");
  }
};

}  // namespace

void add_fleet(CLI::App& app) {
  auto options = std::make_shared<FleetOptions>();
  CLI::App* command = app.add_subcommand("fleet", "Put the reports of many boards into one table, and mark what is unlike the others");
  command->add_option("REPORT", options->reports, "what isotouch qualify --json wrote")->required();
  add_output(*command, "-o,--out", options->out, {&forms::kTable}, "also write the values and their limits, a row for each board");
  command->callback([options] { (*options)(); });
}

}  // namespace isotouch::commands
