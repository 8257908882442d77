/// A text in memory, line by line and field by field, with sentences that name the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/error.h"

namespace isotouch::cloud {

/// Fields are separated by blanks, tabs, commas and semicolons. A carriage return at the end of a line is no part of it.
class TextLines {
 public:
  /// name      of the file, for the sentences
  /// bytes     stay alive and unchanged; a byte order mark of UTF-8 at their begin is skipped
  /// going_on  first words of the lines that a backslash at the end joins with the next, unless a # is in them; they stay alive
  TextLines(std::string name, std::span<const std::uint8_t> bytes, std::span<const std::string_view> going_on = {});

  /// Goes to the next line; false at the end of the text.
  bool next();
  /// The rest of the present line.
  std::string_view rest() const { return rest_; }
  /// The next field of the present line; none at its end.
  std::optional<std::string_view> field();
  /// The next field as a number, which may be infinite or none at all ("nan").
  ///
  /// fails     InputError: the line ends here, or the field is no number; `what` names what was looked for
  double number(std::string_view what);

  std::size_t line() const { return line_; }        ///< of the present line, from 1; the last of those that are joined
  std::size_t bytes_read() const { return next_; }  ///< up to the end of the present line
  std::size_t bytes_left() const { return bytes_.size() - next_; }

  /// "NAME: line N: WHAT"
  InputError refusal(const std::string& what) const;

 private:
  /// Reads one line of the file, without its end.
  std::string_view line_of_file();

  std::string name_;
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::size_t line_ = 0;
  std::string_view rest_;
  std::span<const std::string_view> going_on_;
};

/// How many fields a line has between blanks or semicolons, if one of them has a comma between digits and none has two commas: then they are numbers with
/// decimal commas. Else 0.
std::size_t with_decimal_commas(std::string_view line);
/// The refusal of such a line.
InputError decimal_commas(const TextLines& lines);

/// What stands between the separators in a line, without blanks around it; it may be empty.
///
/// separator   0, or one that is not in the line: the line's fields, none of which is empty
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// The number that the whole field spells; none when it spells no number.
std::optional<double> as_number(std::string_view field);

/// The field in quotes, shortened and without unprintable characters, for a sentence.
std::string quote(std::string_view field);

}  // namespace isotouch::cloud
