/// The first half of a build: a cloud, a mesh or a level set becomes a field in memory. The second half judges and writes it (built_field.h).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/cloud/mesh.h"
#include "host/cloud/oriented_points.h"
#include "host/commands/built_field.h"
#include "host/commands/progress_bar.h"
#include "host/field/band_field.h"
#include "host/field/build_field.h"
#include "host/field/progress.h"
#include "host/field/sound_scan.h"
#include "host/field_file/open_field.h"

namespace isotouch::commands {

/// A field, and what only its maker knows.
struct Made {
  field::BandField field;
  std::optional<std::size_t> inside_nodes = {};
  std::optional<field::SoundScan> scan = {};       ///< of a cloud; workspace, mm
  std::optional<field::Repair> repair = {};        ///< of a scan that is to be judged
  std::optional<field_file::OpenField> live = {};  ///< instead of `field`
  cloud::OrientedPoints live_points = {};          ///< workspace, mm
  cloud::TriangleMesh mesh = {};                   ///< workspace, mm; empty unless the input is one
};

/// How long the stages of a whole build take on two processors: of 120,000 points, of a mesh of 100,000 faces, of a level set of a million voxels.
std::vector<PlannedStage> plan_for(SourceKind kind, BuildMethod method);

/// What a refusal says first where the file of a cloud is a sound mesh; else empty.
std::string better_as_mesh(const BuildReport& report);

/// Reads the input and makes its field, as the options say.
///
/// report    is told what kind of file it is, where it is placed, and what is doubtful about it
/// bar       is told the plan of this kind of build
/// fails     InputError naming the file
Made make_field(const BuildOptions& options, BuildReport& report, ProgressBar& bar, field::Progress& progress);

}  // namespace isotouch::commands
