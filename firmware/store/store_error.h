/// Why a file was not read or written.
#pragma once

#include <cstdint>

#include "shared/result.h"

namespace isotouch::store {

enum class StoreError : std::uint8_t {
  kNotFound,    ///< no such file or folder
  kNotAllowed,  ///< this user may not read or write there, or the name is not allowed
  kTooLarge,    ///< the file does not fit into the memory given
  kDamaged,     ///< the file does not hold what was written to it
  kNoSpace,     ///< the file system is full
  kInUse,       ///< another program has the folder
  kFailed,      ///< reading or writing failed in another way
};

template <class T>
using StoreResult = Result<T, StoreError>;

/// The core of a sentence about a file; the caller adds which file.
constexpr const char* describe(StoreError error) {
  switch (error) {
    case StoreError::kNotFound: return "it is not there";
    case StoreError::kNotAllowed: return "this user may not use it";
    case StoreError::kTooLarge: return "it is larger than expected";
    case StoreError::kDamaged: return "the checksum does not match: the bytes were changed after they were written";
    case StoreError::kNoSpace: return "there is no space left for it";
    case StoreError::kInUse: return "another controller uses it; stop that one, or name another folder";
    case StoreError::kFailed: return "the storage failed";
  }
  return "unknown error";
}

}  // namespace isotouch::store
