#include "host/library/call.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "shared/files/version_text.h"

namespace {

constexpr std::size_t kRoom = 1001;
thread_local std::array<char, kRoom> last_error{};  // NOLINT: the language of C has no other way

}  // namespace

namespace isotouch::library {

void copy_text(const std::string& text, char* to, std::size_t capacity, std::size_t* needed) {
  if (needed != nullptr) *needed = text.size() + 1;
  if (text.size() >= capacity)
    refuse(ISOTOUCH_TOO_SMALL, "the text takes " + std::to_string(text.size() + 1) + " bytes and there is room for " +
                                   std::to_string(capacity) + "; pass more room");
  std::memcpy(required(to, "the text"), text.c_str(), text.size() + 1);
}

}  // namespace isotouch::library

const char* isotouch_last_error(void) { return last_error.data(); }

const char* isotouch_version(void) {
  const char* text = "isotouch, version not known for lack of memory";
  (void)isotouch::library::guarded(ISOTOUCH_INTERNAL, [&] {
    static const std::string& known =
        *new std::string(isotouch::files::short_version_text("isotouch"));  // stays until the process has ended
    text = known.c_str();
  });
  return text;
}

isotouch_status isotouch_fail(isotouch_status status, const char* sentence) {
  std::size_t size = sentence == nullptr ? 0 : std::min(std::strlen(sentence), kRoom - 1);
  if (size == kRoom - 1) {
    while (size > 0 && (static_cast<unsigned char>(sentence[size]) & 0xC0U) == 0x80U) --size;  // no part of a character
  }
  if (size > 0) std::memmove(last_error.data(), sentence, size);
  last_error[size] = 0;
  return status;
}
