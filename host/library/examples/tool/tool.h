/// A tool with one haptic point, in the shape of CHAI3D's `cGenericTool`: read the device, compute the interaction, send the force.
#pragma once

#include <functional>

#include "field_algorithm.h"

class Tool {
 public:
  /// What a device is for a tool.
  struct Device {
    std::function<cVector3d()> getPosition;          ///< m
    std::function<void(const cVector3d&)> setForce;  ///< N
  };

  Tool(Device device, FieldAlgorithm& algorithm) : device_(std::move(device)), algorithm_(algorithm) {}

  void updateFromDevice() { position_ = device_.getPosition(); }
  void computeInteractionForces() { force_ = algorithm_.computeForces(position_, {}); }
  void applyToDevice() const { device_.setForce(force_); }

 private:
  Device device_;
  FieldAlgorithm& algorithm_;
  cVector3d position_, force_;
};
