#include "host/field_file/open_field.h"

#include <utility>

#include "host/error.h"
#include "host/files/file_nature.h"

namespace isotouch::field_file {
namespace {

InputError refused(const std::string& name, const Image& image, Error error) {
  switch (nature_of(image.bytes())) {
    case FileNature::kField: break;
    case FileNature::kPatches: return InputError(name + ": holds patches, no field; name the field that they are for");
    case FileNature::kTrace: return InputError(name + ": is a trace, no field; name the field that it was recorded on");
    case FileNature::kPointer: return InputError(name + kIsPointer);
    case FileNature::kUnknown: return InputError(name + ": is no field; make one of a scan or a mesh with isotouch build");
  }
  return InputError(name + ": not usable as a field: " + describe(error) + "; build it again");
}

}  // namespace

OpenField open_field(const std::filesystem::path& file) { return open_field(read_field(file), file.string()); }

OpenField open_field(StoredField stored, const std::string& name) {
  OpenField field = open_field(std::move(stored.image), name);
  field.invented = std::move(stored.invented);
  return field;
}

OpenField open_field(field_file::Image image, const std::string& name) {
  const Result<FieldView> view = FieldView::parse({image.data(), image.size()});
  if (!view) throw refused(name, image, view.error());
  return {std::move(image), *view};
}

}  // namespace isotouch::field_file
