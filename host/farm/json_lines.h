/// Tables with one JSON object a line, and the values in them.
///
/// real time   no
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
  /// place     of the line, for error messages: "recordings.jsonl, line 3"
  Line(nlohmann::json object, std::string place) : object_(std::move(object)), place_(std::move(place)) {}

  /// The text of a key, not empty.
  ///
  /// fails     InputError: the value is missing, empty or no text, or holds a control character
  std::string text(const char* key) const;
  /// A list of at least one text.
  ///
  /// fails     InputError: the value is missing, empty, or no list of texts
  std::vector<std::string> texts(const char* key) const;
  /// A hash: 16 hexadecimal digits, letters in lower case.
  ///
  /// fails     InputError: as `text`, or no such hash
  std::string hash(const char* key) const;
  bool has(const char* key) const { return object_.contains(key); }
  const std::string& place() const { return place_; }

 private:
  nlohmann::json object_;
  std::string place_;
};

/// Calls `use` for each line of a table, in order; empty lines are left out.
///
/// fails     InputError: the file cannot be read, or a line is no JSON object in UTF-8; also what `use` throws
void each_line(const std::filesystem::path& file, const std::function<void(const Line&)>& use);

}  // namespace isotouch::farm
