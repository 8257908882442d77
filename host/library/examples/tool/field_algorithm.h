/// The force of a tool out of a field, in the shape of CHAI3D's force algorithms (`cGenericForceAlgorithm`): a tool asks it once a tick.
///
/// CHAI3D has metres, x towards the person, y right and z up. The field has millimetres, x right, y up and z towards the person. This class turns between
/// the two. With CHAI3D at hand, derive it from `chai3d::cGenericForceAlgorithm`, include `math/CVector3d.h` instead of `vector.h`, and give it to a tool's
/// haptic point in the place of its proxy.
#pragma once

#include <isotouch.h>

#include <string>

#include "vector.h"

class FieldAlgorithm {
 public:
  /// fails     std::runtime_error with the library's sentence
  FieldAlgorithm(const std::string& field, const isotouch_settings& settings);
  ~FieldAlgorithm();
  FieldAlgorithm(const FieldAlgorithm&) = delete;
  FieldAlgorithm& operator=(const FieldAlgorithm&) = delete;

  /// One tick.
  ///
  /// toolPos   m, CHAI3D's axes
  /// returns   force on the tool, N, CHAI3D's axes
  cVector3d computeForces(const cVector3d& toolPos, const cVector3d& toolVel);

  cVector3d getProxyGlobalPosition() const;
  bool isInContact() const { return felt_.contact != 0; }
  /// m, from the tool to the proxy
  double penetration() const { return felt_.penetration_mm / 1000; }
  const isotouch_field_facts& object() const { return object_; }

  static cVector3d toTool(const double (&field)[3], double scale);
  static void toField(const cVector3d& tool, double (&field)[3], double scale);

 private:
  isotouch_touch touch_ = 0;
  isotouch_field_facts object_{};
  isotouch_felt felt_{};
};
