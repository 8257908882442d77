#include "field_algorithm.h"

#include <stdexcept>

namespace {

void orThrow(isotouch_status status) {
  if (status != ISOTOUCH_OK) throw std::runtime_error(isotouch_last_error());
}

}  // namespace

FieldAlgorithm::FieldAlgorithm(const std::string& field, const isotouch_settings& settings) {
  isotouch_field loaded = 0;
  orThrow(isotouch_field_load(field.c_str(), &loaded));
  const isotouch_status described = isotouch_field_describe(loaded, &object_, sizeof object_);
  const isotouch_status begun = described == ISOTOUCH_OK ? isotouch_touch_new(loaded, &settings, sizeof settings, &touch_) : described;
  const std::string why = isotouch_last_error();
  isotouch_free(loaded);  // the touch keeps what it needs
  if (begun != ISOTOUCH_OK) throw std::runtime_error(why);
}

FieldAlgorithm::~FieldAlgorithm() { isotouch_free(touch_); }

cVector3d FieldAlgorithm::toTool(const double (&field)[3], double scale) { return {field[2] * scale, field[0] * scale, field[1] * scale}; }

void FieldAlgorithm::toField(const cVector3d& tool, double (&field)[3], double scale) {
  field[0] = tool.y() * scale, field[1] = tool.z() * scale, field[2] = tool.x() * scale;
}

cVector3d FieldAlgorithm::computeForces(const cVector3d& toolPos, const cVector3d& /*toolVel*/) {  // the core finds the velocity itself
  double hip[3];
  toField(toolPos, hip, 1000);
  orThrow(isotouch_touch_position(touch_, hip, 0, &felt_, sizeof felt_));
  return toTool(felt_.force_n, 1);
}

cVector3d FieldAlgorithm::getProxyGlobalPosition() const { return toTool(felt_.proxy_mm, 0.001); }
