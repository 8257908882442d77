/// An image together with the checked view on it, and what its file says beside it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "host/field_file/image.h"
#include "shared/field_view.h"

namespace isotouch::field_file {

/// Moves keep the view valid; copies would not, so there are none.
struct OpenField {
  field_file::Image image;
  FieldView view;
  Marks invented = {};  ///< bricks whose surface closes the scan where nobody scanned it

  OpenField(field_file::Image bytes, const FieldView& checked) : image(std::move(bytes)), view(checked) {}
  OpenField(OpenField&&) = default;
  OpenField& operator=(OpenField&&) = default;
  OpenField(const OpenField&) = delete;
  OpenField& operator=(const OpenField&) = delete;
};

/// fails     InputError naming the file: cannot be read, or why FieldView::parse refuses it
OpenField open_field(const std::filesystem::path& file);

/// The same for what was read from a file; `name` stands for the file in the sentence.
OpenField open_field(StoredField stored, const std::string& name);

/// The same for an image in memory; `name` stands for the file in the sentence.
OpenField open_field(field_file::Image image, const std::string& name);

}  // namespace isotouch::field_file
