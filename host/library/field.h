/// A field behind a handle.
#pragma once

#include <memory>
#include <utility>

#include "host/field_file/open_field.h"
#include "host/library/handles.h"

namespace isotouch::library {

struct FieldThing final : Thing {
  explicit FieldThing(field_file::OpenField field)
      : Thing(Kind::kField), open(std::make_shared<const field_file::OpenField>(std::move(field))) {}

  std::shared_ptr<const field_file::OpenField> open;  ///< a touch holds it, too
};

}  // namespace isotouch::library
