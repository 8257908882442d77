/// The fields that a controller keeps, and which of them it begins with: files in one folder.
///
///   NUMBER-HASH-NAME.itf   a packed field as it was uploaded; NUMBER counts up, so that the oldest is known without a clock; HASH names the image
///   active                 the hash of one of them, 16 hexadecimal digits
///
/// Each file is written beside its place, synced, renamed, and the folder synced: a power cut at any moment leaves the old field active or the new
/// one, whole. Used by one thread; not for the tick.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/store/folder.h"
#include "firmware/store/store_error.h"

namespace isotouch::store {

struct StoredField {
  std::uint32_t number = 0;
  std::uint64_t hash = 0;
  std::uint64_t bytes = 0;
  std::string name;  ///< for people: letters, digits, '-' and '_'
  std::string file;
};

class FieldStore {
 public:
  static constexpr std::size_t kMaxName = 40;

  /// folder    lives longer; other files in it are left alone
  /// most      fields kept, at least 2: the oldest go first, never the active one
  FieldStore(Folder& folder, std::size_t most);

  /// Oldest first.
  std::vector<StoredField> list();

  /// The hash of the field to begin with; nothing when there is none, or when the file that tells it is not as above.
  std::optional<std::uint64_t> active();

  /// The packed field of that hash. fails kNotFound and as Folder::read. What it holds is for the reader to check
  StoreResult<std::size_t> read(std::uint64_t hash, std::span<std::uint8_t> out);

  /// Stores a field; it survives a power cut from here on. One of the same hash is replaced.
  ///
  /// fails     kNotAllowed, kNoSpace, kFailed: then nothing that was stored is lost
  StoreResult<void> put(std::uint64_t hash, std::string_view name, std::span<const std::uint8_t> packed);

  /// Says which stored field is the active one; survives a power cut from here on.
  ///
  /// fails     as `put`; then it is the one before, or, after kFailed, either
  StoreResult<void> set_active(std::uint64_t hash);

  /// The next start begins with the field that was active before, and not with this one; survives a power cut from here on.
  ///
  /// before    nothing: with none
  /// remove    the field itself is taken away, too
  /// fails     kNotAllowed, kNoSpace, kFailed
  StoreResult<void> take_back(std::uint64_t hash, std::optional<std::uint64_t> before, bool remove);

  bool holds(std::uint64_t hash);

 private:
  StoreResult<void> write(const std::string& file, std::span<const std::uint8_t> bytes);
  void drop_oldest(std::uint64_t newest);

  Folder& folder_;
  std::size_t most_;
};

}  // namespace isotouch::store
