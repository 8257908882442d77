/// Is the field that was built a plausible body of its scan? The last check of a build from points by the default method.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/field/band_field.h"
#include "host/field/build_field.h"
#include "host/field/sound_scan.h"
#include "host/field/spacings.h"

namespace isotouch::field {

/// Said after a file's name and ": " of a field without any inside, which nobody can accept.
inline constexpr const char* kEmptyField =
    "the field is empty: the points do not enclose a body; scan more densely, or check their normals";

/// Figures by which a build is judged. Shares are of 1.
struct Verdict {
  std::vector<std::string> reasons;  ///< why the field may be wrong, and what to do; one sentence each; empty = plausible
  double noise_spacing = 0;          ///< noise over the distance between neighbours
  double stray_share = 0;            ///< of the points: left out as strays
  double turned_share = 0;           ///< of the normals: turned round
  double invented_share = 0;         ///< of the surface: nobody scanned it (invented_surface.h)
  double gap_share = 0;              ///< of the surface: as far from every point that shows it, invented ones too (unseen_share.h)
  double unseen_end_share = 0;       ///< of the surface: it closes hollows into which the scan sees, but not to their end (unseen_end.h)
  double surprising_share = 0;       ///< of the surface: its samples lie more than a voxel off where their neighbours expect it
  double rim_mm = 0;                 ///< length of all open rims together
  double volume_of_hull = 0;      ///< the body's volume over that of the convex hull of all points, invented ones too (cut by 196 planes)
  double volume_of_enclosed = 1;  ///< the body's volume over what the points' areas and normals enclose; 1 for a scan of one side
  double off_surface_share = 0;   ///< of the measured points: more than a voxel, and more than the noise explains, off the field's surface
  double thin_share = 0;          ///< of the measured points: on walls of about 1.5 voxels and less, or as near to an edge
  double unexplained_share = 0;   ///< of the samples: no local surface explains their neighbours
  double debris_share = 0;        ///< pieces and cavities that no points stand for, over the number of points
  double contradicted_share = 0;  ///< of the clear pairs of neighbours: their normals contradict each other still
  double opposed_share = 0;       ///< of the measured normals: against the field's gradient
  bool empty = false;             ///< the field has no inside at all, so that there is nothing to accept

  bool plausible() const { return reasons.empty(); }
};

/// Why no method should be trusted with this scan, whatever field it makes: one sentence each.
std::vector<std::string> reasons_of_scan(const SoundScan& sound);

/// sound     workspace, mm; what `field` was built from
/// spacings  of all its points
/// returns   all but `invented_share`
Verdict judge(const BandField& field, const SoundScan& sound, const Repair& repair, const Spacings& spacings);

}  // namespace isotouch::field
