#include "host/bag/ros2_bag.h"

#include <sqlite3.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "host/error.h"

namespace isotouch::bag {

namespace {

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

std::string_view text_in(sqlite3_stmt* row, int column) {
  const void* bytes = sqlite3_column_blob(row, column);
  return {static_cast<const char*>(bytes), bytes == nullptr ? 0 : static_cast<std::size_t>(sqlite3_column_bytes(row, column))};
}

}  // namespace

bool is_sqlite(std::span<const std::uint8_t> begin) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  return begin.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), begin.begin());
}

void read_ros2_bag(const std::filesystem::path& file,
                   const std::function<void(const Channel&, std::uint64_t, std::span<const std::uint8_t>)>& use) {
  sqlite3* opened = nullptr;
  const int outcome = sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
  const std::unique_ptr<sqlite3, Close> database(opened);
  const auto refuse = [&] {
    throw InputError(file.string() + ": it cannot be read as a recording of ROS 2 (" +
                     (opened == nullptr ? "no memory" : sqlite3_errmsg(opened)) +
                     "); give a .db3 file of rosbag2 whose recorder has ended, or convert it with: ros2 bag convert");
  };
  if (outcome != SQLITE_OK) refuse();
  sqlite3_exec(opened, "PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
  // A view would be a program of a stranger.
  constexpr const char* kTables = "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name IN ('topics', 'messages')";
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(opened, kTables, -1, &prepared, nullptr) != SQLITE_OK) refuse();
  const std::unique_ptr<sqlite3_stmt, Close> tables(prepared);
  if (sqlite3_step(prepared) != SQLITE_ROW || sqlite3_column_int(prepared, 0) != 2) refuse();
  prepared = nullptr;
  constexpr const char* kQuery =
      "SELECT topics.name, topics.type, topics.serialization_format, messages.timestamp, messages.data "
      "FROM messages LEFT JOIN topics ON messages.topic_id = topics.id ORDER BY messages.timestamp, messages.id";
  if (sqlite3_prepare_v2(opened, kQuery, -1, &prepared, nullptr) != SQLITE_OK) refuse();
  const std::unique_ptr<sqlite3_stmt, Close> row(prepared);
  int step = sqlite3_step(prepared);
  for (; step == SQLITE_ROW; step = sqlite3_step(prepared)) {
    if (sqlite3_column_type(prepared, 0) == SQLITE_NULL) {
      throw InputError(file.string() + ": it is damaged: the message of " + std::to_string(sqlite3_column_int64(prepared, 3)) +
                       " ns belongs to no topic that it has; record it again");
    }
    const std::string_view data = text_in(prepared, 4);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): text as bytes
    use({text_in(prepared, 0), text_in(prepared, 1), text_in(prepared, 2)}, static_cast<std::uint64_t>(sqlite3_column_int64(prepared, 3)),
        {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()});
  }
  if (step != SQLITE_DONE) refuse();
}

}  // namespace isotouch::bag
