/// An image together with the checked view on it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "host/blob/image.h"
#include "shared/blob.h"

namespace isotouch::blob {

/// Moves keep the view valid; copies would not, so there are none.
struct OpenBlob {
  blob::Image image;
  BlobView view;

  OpenBlob(blob::Image bytes, const BlobView& checked) : image(std::move(bytes)), view(checked) {}
  OpenBlob(OpenBlob&&) = default;
  OpenBlob& operator=(OpenBlob&&) = default;
  OpenBlob(const OpenBlob&) = delete;
  OpenBlob& operator=(const OpenBlob&) = delete;
};

/// fails     InputError naming the file: cannot be read, or why BlobView::parse refuses it
OpenBlob open_blob(const std::filesystem::path& file);

/// The same for an image in memory; `name` stands for the file in the sentence.
OpenBlob open_blob(blob::Image image, const std::string& name);

}  // namespace isotouch::blob
