/// The seam to a folder of files. Every call is a step that a power cut may follow or fall into; only what was synced survives one for certain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firmware/store/store_error.h"

namespace isotouch::store {

class Folder {
 public:
  virtual ~Folder() = default;

  /// Names of its files, in any order. Empty when it cannot be read.
  virtual std::vector<std::string> names() = 0;

  /// Bytes of a file. fails kNotFound
  virtual StoreResult<std::uint64_t> size(const std::string& name) = 0;

  /// Reads a whole file. returns its bytes; fails kNotFound, kNotAllowed, kTooLarge (larger than `out`), kFailed
  virtual StoreResult<std::size_t> read(const std::string& name, std::span<std::uint8_t> out) = 0;

  /// Makes a file, in place of one of that name. fails kNotAllowed, kNoSpace, kFailed
  virtual StoreResult<void> write(const std::string& name, std::span<const std::uint8_t> bytes) = 0;

  /// The content of a file survives from here on. fails kNoSpace, kFailed
  virtual StoreResult<void> sync(const std::string& name) = 0;

  /// In place of a file of the new name, if there is one. fails kNotFound, kNotAllowed, kFailed
  virtual StoreResult<void> rename(const std::string& from, const std::string& to) = 0;

  /// fails kNotFound, kNotAllowed, kFailed
  virtual StoreResult<void> remove(const std::string& name) = 0;

  /// What was made, renamed and removed survives from here on. fails kFailed
  virtual StoreResult<void> sync_names() = 0;
};

}  // namespace isotouch::store
