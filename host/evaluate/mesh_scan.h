/// A person who scans an object by touch, simulated: a hand that strokes a mesh all over, and the god-object that it feels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "host/field/triangle_tree.h"
#include "shared/settings_table.h"
#include "shared/tick_io.h"

namespace isotouch::evaluate {

struct MeshScanOptions {
  double seconds = 300;  ///< at most; the hand stops when it has been everywhere it can reach
  std::uint64_t seed = 1;
  double stiffness_n_per_mm = 0.8;
};

struct MeshScanReport {
  std::uint64_t ticks = 0;
  std::uint64_t touching = 0;
  std::size_t strokes = 0;
  std::size_t targets = 0;  ///< spread over the surface, as far apart as the time allows
  std::size_t reached = 0;  ///< of them
  double deepest_mm = 0;    ///< hand below the god-object
};

inline constexpr std::uint32_t kScanPeriodNs = 1'000'000;
inline constexpr double kScanForceLimit = rows::kForceLimit.high;  ///< N, the most that a trace allows

/// Strokes from target to target, nearest and straight ahead first, 80 to 120 mm/s fast and 0.5 to 2 mm deep along the normals; where no target is
/// left nearby, or after some seconds, the hand lifts off by a way that it has looked along, and begins elsewhere. What follows the script is a hand: a
/// mass with limited speed and acceleration that trembles by 0.03 mm at 9 to 12 Hz. Its force is stiffness · (god-object - HIP), shortened to
/// kScanForceLimit where it must be, and then marked.
///
/// tree      of what can be touched of a closed mesh, workspace, mm
/// emit      takes each tick in its order: the HIP as a trace holds it, and what is felt there
/// same      for a seed on every machine: + − × ÷ and square roots only
MeshScanReport scan_mesh(const field::TriangleTree& tree, const MeshScanOptions& options,
                         const std::function<void(const Input&, const Output&)>& emit);

}  // namespace isotouch::evaluate
