#include "host/board_commands/print_key.h"

#include <algorithm>
#include <cstdio>

#include "host/error.h"
#include "host/files/json_text.h"

namespace isotouch::commands {

namespace {

std::string plain(const nlohmann::ordered_json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return json_text(value);
  std::string text;
  for (const auto& part : value) text += (text.empty() ? "" : " ") + plain(part);
  return text;
}

}  // namespace

void print_key(const nlohmann::ordered_json& json, const std::string& name) {
  const nlohmann::ordered_json* value = &json;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    const std::string key = name.substr(begin, end - begin);
    if (!value->is_object() || !value->contains(key)) {
      std::string keys;
      if (value->is_object()) {
        for (const auto& [known, ignored] : value->items()) keys += " " + known;
      }
      const std::string sentence = "--key " + name + ": there is no '" + key + "'" + (keys.empty() ? "" : "; there are" + keys);
      if (begin == 0) throw UsageError(sentence);
      throw InputError(sentence);  // which keys an object within has may depend on the controller
    }
    value = &(*value)[key];
    begin = end + 1;
  }
  std::printf("%s\n", plain(*value).c_str());
}

}  // namespace isotouch::commands
