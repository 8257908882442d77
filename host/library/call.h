/// The border to C: no exception crosses it, and each failure leaves a sentence.
#pragma once

#include <cxxabi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "host/error.h"
#include "host/library/isotouch.h"

namespace isotouch::library {

/// What a call says that does not succeed, beside what its data are refused with (InputError).
class CallError : public std::runtime_error {
 public:
  CallError(isotouch_status status, const std::string& sentence) : std::runtime_error(sentence), status_(status) {}
  isotouch_status status() const { return status_; }

 private:
  isotouch_status status_;
};

[[noreturn]] inline void refuse(isotouch_status status, const std::string& sentence) { throw CallError(status, sentence); }

/// Runs the body of a call.
///
/// refused   what an InputError means in this call
/// body      may throw
template <class Body>
isotouch_status guarded(isotouch_status refused, Body&& body) {
  try {
    std::forward<Body>(body)();
    return ISOTOUCH_OK;
  } catch (const CallError& error) {
    return isotouch_fail(error.status(), error.what());
  } catch (const InputError& error) {
    return isotouch_fail(refused, error.what());
  } catch (const std::bad_alloc&) {
    return isotouch_fail(ISOTOUCH_NO_MEMORY, "there is not enough memory for this call; free what is not needed");
  } catch (const std::exception& error) {
    return isotouch_fail(ISOTOUCH_INTERNAL, error.what());
  } catch (const abi::__forced_unwind&) {  // the thread is being ended, and must end
    throw;
  } catch (...) {
    return isotouch_fail(ISOTOUCH_INTERNAL, "something was thrown that nobody knows; please report it");
  }
}

/// fails     CallError naming the argument, where it is null
template <class T>
T* required(T* pointer, const char* name) {
  if (pointer == nullptr) refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " is a null pointer; pass the address of a variable");
  return pointer;
}

/// The name of a file as the caller means it: for the functions behind, `-` alone would be standard input or output.
///
/// fails     CallError: null, or empty
inline std::string file_name(const char* path) {
  const std::string name = required(path, "path");
  if (name.empty()) refuse(ISOTOUCH_BAD_ARGUMENT, "path is empty; name a file");
  return name == "-" ? "./-" : name;
}

/// fails     CallError naming the structure, where it has another size here. Each still has its first size; whoever adds a member also takes the sizes
///           before, of programs that do not know it
inline void require_size(std::size_t passed, std::size_t wanted, const char* name) {
  if (passed == wanted) return;
  refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " has " + std::to_string(passed) + " bytes instead of " + std::to_string(wanted) +
                                    "; pass its sizeof, and compile with the header of this library");
}

/// Of a structure that may be null.
///
/// fails     CallError: another size; null is 0 bytes
template <class Struct>
void require_optional(const Struct* structure, std::size_t passed, const char* name) {
  if (structure != nullptr) return require_size(passed, sizeof *structure, name);
  if (passed == 0) return;
  refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + " is a null pointer of " + std::to_string(passed) +
                                    " bytes; pass its address, or 0 as its size for the defaults");
}

/// fails     CallError: null, or another size
template <class Struct>
void require_struct(Struct* structure, const char* argument, std::size_t passed, const char* name) {
  (void)required(structure, argument);
  require_size(passed, sizeof *structure, name);
}

/// fails     CallError, where no memory holds so many items of so many bytes: a wrong size, such as -1
inline void require_count(std::size_t count, std::size_t item_bytes, const char* name) {
  if (count <= PTRDIFF_MAX / item_bytes) return;
  refuse(ISOTOUCH_BAD_ARGUMENT, std::to_string(count) + " " + name + " fit no memory; pass the number of those that are there");
}

/// Copies a text with its zero into the caller's memory.
///
/// fails     CallError, where it does not fit or its memory is null; `needed` is set all the same
void copy_text(const std::string& text, char* to, std::size_t capacity, std::size_t* needed);

/// fails     CallError, where one of them is not finite
inline void require_finite(const double* numbers, std::size_t count, const char* name) {
  const double* const wrong = std::find_if_not(numbers, numbers + count, [](double number) { return std::isfinite(number); });
  if (wrong == numbers + count) return;
  refuse(ISOTOUCH_BAD_ARGUMENT, std::string(name) + ": number " + std::to_string(wrong - numbers) +
                                    " (counted from 0) is not finite; leave out places that are not known");
}

}  // namespace isotouch::library
