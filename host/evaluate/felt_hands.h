/// Hands that touch an object in the ways that people do: planned on the true surface, so that no field decides where they go.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/evaluate/felt_path.h"
#include "host/evaluate/true_trees.h"

namespace isotouch::evaluate {

enum class FeltKind : std::uint8_t { kPress, kSlide100, kSlide300, kScrub, kStab, kEdge, kCrease, kThin, kRecorded };
inline constexpr std::array<std::string_view, 9> kFeltKindNames = {"press", "slide_100", "slide_300", "scrub",   "stab",
                                                                   "edge",  "crease",    "thin",      "recorded"};
constexpr std::string_view name_of(FeltKind kind) { return kFeltKindNames[static_cast<std::size_t>(kind)]; }

/// An edge is sharp from this angle between its faces on. A part is thin up to this thickness.
inline constexpr double kSharpDeg = 30;
inline constexpr double kThinMm = 3;

/// The motion of a recorded hand, whatever it touched.
struct RecordedHand {
  std::string name;                        ///< of its file
  std::vector<Eigen::Vector3d> positions;  ///< mm, one a millisecond
};

struct FeltHand {
  FeltKind kind;
  std::size_t number;           ///< of its kind, from 0
  std::string from;             ///< the recording, if there is one
  std::vector<FeltTick> ticks;  ///< one a millisecond; the first is outside the body
};

struct FeltHandOptions {
  std::uint64_t seed = 1;
  double share = 1;  ///< of the usual number of hands, for tests
};

/// press      along the normal to a depth of 0.3 to 1 mm and out again
/// slide      at 0.1 to 1 mm below the surface, 100 and 300 mm/s, on a way that bends
/// scrub      the same to and fro, three times a second, at up to 180 mm/s
/// stab       1 m/s from up to 72.5 degrees beside the normal, stops at 0.1 to 1 mm, rests, and leaves as fast
/// edge       crosses convex sharp edges to and fro while it runs along them
/// crease     below concave sharp edges, along them; every second hand from wall to wall
/// thin       through parts of at most kThinMm, in along the normal, 1 mm out on the other side, and back
/// recorded   a recorded hand in pieces of 2 s, each on another place: what it moves along its main plane becomes motion along the surface, what it
///            moves across, within half a second, becomes depth between 0.1 and 1 mm
///
/// trees      of the true surface: workspace, mm
/// returns    kind by kind; nothing of a kind for which the object has no place. The same for a seed and for any number of threads
/// fails      InputError: no place of the mesh can be touched from outside
std::vector<FeltHand> felt_hands(const TrueTrees& trees, const std::vector<RecordedHand>& recorded, const FeltHandOptions& options);

}  // namespace isotouch::evaluate
