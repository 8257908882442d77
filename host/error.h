/// What the host tool throws when its input is at fault; `main` prints the sentence and returns 1.
#pragma once

#include <stdexcept>
#include <string>

namespace isotouch {

/// One clear sentence: file, place, what is wrong, what to do.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same of the command line itself: a value that an option does not take, or options that do not belong together. `main` returns 2.
class UsageError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace isotouch
