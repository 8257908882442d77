/// Tables with one JSON object a line, and the values in them.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace isotouch::farm {

/// One line of a table.
class Line {
 public:
  /// place     of the line, for sentences: "recordings.jsonl, line 3"
  Line(nlohmann::json object, std::string place) : object_(std::move(object)), place_(std::move(place)) {}

  /// fails     InputError: the value is missing, empty, or no text that a terminal may get
  std::string text(const char* key) const;
  /// The same for a list of texts with at least one.
  std::vector<std::string> texts(const char* key) const;
  /// The same for a hash of 16 hexadecimal digits.
  std::string hash(const char* key) const;
  const std::string& place() const { return place_; }

 private:
  nlohmann::json object_;
  std::string place_;
};

/// Empty lines are left out.
///
/// fails     InputError naming file and line: no JSON object; what `use` throws
void each_line(const std::filesystem::path& file, const std::function<void(const Line&)>& use);

}  // namespace isotouch::farm
