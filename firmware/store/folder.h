/// The seam to a folder of files. Every call is a step that a power cut may follow or fall into; only what was synced survives one for certain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/result.h"

namespace isotouch::store {

class Folder {
 public:
  virtual ~Folder() = default;

  /// Names of its files, in any order. Empty when it cannot be read.
  virtual std::vector<std::string> names() = 0;

  /// Bytes of a file. fails kNotFound
  virtual Result<std::uint64_t> size(const std::string& name) = 0;

  /// Reads a whole file. returns its bytes; fails kNotFound, kNotAllowed, kBadSize (larger than `out`), kStorage
  virtual Result<std::size_t> read(const std::string& name, std::span<std::uint8_t> out) = 0;

  /// Makes a file, in place of one of that name. fails kNotAllowed, kNoSpace, kStorage
  virtual Result<void> write(const std::string& name, std::span<const std::uint8_t> bytes) = 0;

  /// The content of a file survives from here on. fails kNoSpace, kStorage
  virtual Result<void> sync(const std::string& name) = 0;

  /// In place of a file of the new name, if there is one. fails kNotFound, kNotAllowed, kStorage
  virtual Result<void> rename(const std::string& from, const std::string& to) = 0;

  /// fails kNotFound, kNotAllowed, kStorage
  virtual Result<void> remove(const std::string& name) = 0;

  /// What was made, renamed and removed survives from here on. fails kStorage
  virtual Result<void> sync_names() = 0;
};

}  // namespace isotouch::store
