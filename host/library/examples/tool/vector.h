/// As much of CHAI3D's `cVector3d` as the example needs.
#pragma once

#include <cmath>

class cVector3d {
 public:
  cVector3d() = default;
  cVector3d(double x, double y, double z) : x_(x), y_(y), z_(z) {}
  double x() const { return x_; }
  double y() const { return y_; }
  double z() const { return z_; }
  double length() const { return std::sqrt(x_ * x_ + y_ * y_ + z_ * z_); }

 private:
  double x_ = 0, y_ = 0, z_ = 0;
};
