#include "host/blob/open_blob.h"

#include <utility>

#include "host/error.h"

namespace isotouch::blob {

OpenBlob open_blob(const std::filesystem::path& file) { return open_blob(blob::read_image(file), file.string()); }

OpenBlob open_blob(blob::Image image, const std::string& name) {
  const Result<BlobView> view = BlobView::parse({image.data(), image.size()});
  if (!view) throw InputError(name + ": not usable as a blob: " + describe(view.error()) + "; build it again");
  return {std::move(image), *view};
}

}  // namespace isotouch::blob
