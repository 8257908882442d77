#include "firmware/store/field_store.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include "firmware/store/whole_file.h"

namespace isotouch::store {

namespace {

const std::string kActive = "active";
const std::string kPart = "new.part";
constexpr std::string_view kExtension = ".itf";
constexpr std::size_t kNumberDigits = 8, kHashDigits = 16;
constexpr std::size_t kNameAt = kNumberDigits + 1 + kHashDigits + 1;

std::string digits(std::uint64_t value, std::size_t count, unsigned base) {
  std::string text(count, '0');
  for (std::size_t i = count; i-- > 0; value /= base) text[i] = "0123456789abcdef"[value % base];
  return text;
}

/// All characters are digits of that base.
template <class T>
std::optional<T> number(std::string_view text, int base) {
  T value{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string file_name(std::uint32_t count, std::uint64_t hash, std::string_view name) {
  std::string file = digits(count, kNumberDigits, 10) + "-" + digits(hash, kHashDigits, 16) + "-";
  for (const char c : name.substr(0, FieldStore::kMaxName)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    file += plain ? c : '_';
  }
  return file + std::string(kExtension);
}

std::optional<StoredField> read_name(const std::string& file) {
  const std::string_view view = file;
  if (view.size() < kNameAt + kExtension.size() || view.substr(view.size() - kExtension.size()) != kExtension) return std::nullopt;
  if (view[kNumberDigits] != '-' || view[kNameAt - 1] != '-') return std::nullopt;
  const auto count = number<std::uint32_t>(view.substr(0, kNumberDigits), 10);
  const auto hash = number<std::uint64_t>(view.substr(kNumberDigits + 1, kHashDigits), 16);
  if (!count || !hash) return std::nullopt;
  return StoredField{*count, *hash, 0, std::string(view.substr(kNameAt, view.size() - kNameAt - kExtension.size())), file};
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

FieldStore::FieldStore(Folder& folder, std::size_t most) : folder_(folder), most_(most) {
  assert(most >= 2);
  if (folder_.size(kPart)) (void)folder_.remove(kPart);  // of a run that was killed
}

std::vector<StoredField> FieldStore::list() {
  std::vector<StoredField> fields;
  for (const std::string& name : folder_.names()) {
    std::optional<StoredField> field = read_name(name);
    if (!field) continue;
    const StoreResult<std::uint64_t> size = folder_.size(name);
    field->bytes = size ? *size : 0;
    fields.push_back(*std::move(field));
  }
  std::sort(fields.begin(), fields.end(), [](const StoredField& a, const StoredField& b) { return a.file < b.file; });
  return fields;
}

std::optional<std::uint64_t> FieldStore::active() {
  std::array<std::uint8_t, kHashDigits + 1> text{};
  const StoreResult<std::size_t> got = folder_.read(kActive, text);
  if (!got || *got != text.size() || text.back() != '\n') return std::nullopt;
  return number<std::uint64_t>({reinterpret_cast<const char*>(text.data()), kHashDigits}, 16);
}

StoreResult<std::size_t> FieldStore::read(std::uint64_t hash, std::span<std::uint8_t> out) {
  for (const StoredField& field : list()) {
    if (field.hash == hash) return folder_.read(field.file, out);
  }
  return StoreError::kNotFound;
}

StoreResult<void> FieldStore::put(std::uint64_t hash, std::string_view name, std::span<const std::uint8_t> packed) {
  const std::vector<StoredField> before = list();
  const std::uint32_t count = before.empty() ? 0 : before.back().number;
  const StoreResult<void> written = write(file_name(count + 1, hash, name), packed);
  if (!written) return written;
  for (const StoredField& field : before) {  // what is sent again is the newest
    if (field.hash == hash) (void)folder_.remove(field.file);
  }
  drop_oldest(hash);
  return written;
}

StoreResult<void> FieldStore::set_active(std::uint64_t hash) { return write(kActive, bytes_of(digits(hash, kHashDigits, 16) + "\n")); }

StoreResult<void> FieldStore::take_back(std::uint64_t hash, std::optional<std::uint64_t> before, bool remove) {
  StoreResult<void> done = before ? set_active(*before) : folder_.remove(kActive);
  for (const StoredField& field : list()) {
    if (done && remove && field.hash == hash) done = folder_.remove(field.file);
  }
  return done ? folder_.sync_names() : done;
}

bool FieldStore::holds(std::uint64_t hash) {
  const std::vector<StoredField> fields = list();
  return std::any_of(fields.begin(), fields.end(), [&](const StoredField& field) { return field.hash == hash; });
}

StoreResult<void> FieldStore::write(const std::string& file, std::span<const std::uint8_t> bytes) {
  return write_whole(folder_, kPart, file, bytes);
}

/// As many as there are too many; a file that stays because it cannot be removed does no harm.
void FieldStore::drop_oldest(std::uint64_t newest) {
  const std::vector<StoredField> fields = list();
  const std::optional<std::uint64_t> kept = active();
  std::size_t over = fields.size() > most_ ? fields.size() - most_ : 0;
  for (auto field = fields.begin(); field != fields.end() && over > 0; ++field) {
    if (field->hash == newest || field->hash == kept) continue;
    if (folder_.remove(field->file)) --over;
  }
}

}  // namespace isotouch::store
