/// A grid or an image that the format of a field has no room for.
#pragma once

#include <string>

#include "host/error.h"

namespace isotouch::field {

/// Its remedy is that of a build. A command that has no such options says its own behind the fact.
class DoesNotFit : public InputError {
 public:
  DoesNotFit(const std::string& fact, const std::string& remedy) : InputError(fact + "; " + remedy), fact_(fact) {}
  const std::string& fact() const { return fact_; }

 private:
  std::string fact_;
};

}  // namespace isotouch::field
