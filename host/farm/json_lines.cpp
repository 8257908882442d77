#include "host/farm/json_lines.h"

#include <string_view>

#include "host/error.h"
#include "host/files/whole_file.h"
#include "host/trace/hash_text.h"
#include "shared/printable.h"

namespace isotouch::farm {

std::string Line::text(const char* key) const {
  const auto found = object_.find(key);
  if (found == object_.end() || !found->is_string() || found->get_ref<const std::string&>().empty())
    throw InputError(place_ + ": \"" + key + "\" is missing or no text; give it a text");
  if (!is_printable(found->get_ref<const std::string&>()))
    throw InputError(place_ + ": \"" + key + "\" holds a control character; leave it out");
  return *found;
}

std::vector<std::string> Line::texts(const char* key) const {
  std::vector<std::string> words;
  const auto found = object_.find(key);
  if (found != object_.end() && found->is_array()) {
    for (const auto& word : *found) {
      if (!word.is_string()) throw InputError(place_ + ": \"" + key + "\" holds something that is no text; write each word in quotes");
      words.push_back(word);
    }
  }
  if (words.empty()) throw InputError(place_ + ": \"" + key + "\" is missing or no list of texts; write [\"word\", \"word\"]");
  return words;
}

std::string Line::hash(const char* key) const {
  std::string digits = text(key);
  if (!trace::is_hash_text(digits))
    throw InputError(place_ + ": \"" + key + "\" is '" + digits + "'; a hash has 16 hexadecimal digits, letters in lower case");
  return digits;
}

void each_line(const std::filesystem::path& file, const std::function<void(const Line&)>& use) {
  const std::vector<std::uint8_t> bytes = read_file(file);
  std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const std::string place = file.string() + ", line " + std::to_string(number);
    nlohmann::json object = nlohmann::json::parse(line, nullptr, false);
    if (!object.is_object()) throw InputError(place + ": no JSON object in UTF-8; write each on one line");
    use(Line(std::move(object), place));
  }
}

}  // namespace isotouch::farm
