/// What a field promises of itself, measured while it is written, so that a controller can refuse what it cannot hold.
#pragma once

#include <cstdint>
#include <vector>

#include "host/encoding/apron.h"
#include "host/encoding/spline.h"
#include "host/field/band_field.h"
#include "shared/field_view.h"
#include "shared/settings_table.h"

namespace isotouch::encoding {

struct Certificate {
  double largest_slope = 0.0;        ///< a bound of |∇φ| over all stored bricks, voxels a voxel; 0 = the field has no certificate
  double quantisation_voxel = 0.0;   ///< how far rounding the coefficients moves the distance at most, voxels
  double thinnest_wall_voxel = 0.0;  ///< between two sides that face away from each other; 0 = none that both bands see
  double stiffness_n_per_mm = 0.0;   ///< the largest advisable one for the three numbers below
  std::uint32_t period_ns = 1'000'000;
  double damping_n_s_mm = rows::kAssumedDamping;         ///< of the device
  std::uint32_t delay_ticks = rows::kAssumedDelayTicks;  ///< from encoder to motor command
};

/// K = 2 b / ((2 d + 1) T), N/mm: above it a sampled wall feeds energy into the hand.
///
/// source    Colgate and Schenkel, Passivity of a class of sampled-data systems, 1997, with d whole periods of delay
double advisable_stiffness(double damping_n_s_mm, std::uint32_t delay_ticks, std::uint32_t period_ns);

/// field          as it was sampled
/// around         its `neighbours`
/// coefficients   of its spline, one brick for each of the field's
/// returns        the slope from above: in each cell every component of the gradient is a mean of differences of neighbouring coefficients.
///                The wall from two samples on both sides of its middle, up to about twice the band. One that is a voxel thick or more is always
///                found, and said to be up to 0.6 voxel thinner than it is, never thicker: 6,000 plates turned at random gave 0 to 0.56, 2026-11-29.
///                A thinner one is found where the written field is more than 0.05 voxel inside; elsewhere it may have no inside at all
/// source         derivatives of B-splines: de Boor, A Practical Guide to Splines, 1978, chapter X
Certificate certify(const field::BandField& field, const std::vector<Neighbours>& around, const std::vector<Coefficients>& coefficients);

/// The parts of it, for whoever keeps them brick by brick.
///
/// The largest |∇φ|² in the cells around a brick's samples, from above; steps to samples that are no number do not count.
float squared_slope(const Apron& coefficients);

/// A brick with two rings around it, 8 samples a side, x fastest; NaN where nothing is known.
using Surroundings = std::array<float, 512>;
/// The least thickness of a wall whose middle lies beside one of the brick's samples, or `most` where it has none that is thinner.
///
/// coefficients   of the brick, as they are written: there is a wall only where one of them is negative
float thinnest_wall(const Surroundings& distance, const Samples& coefficients, float most);

/// squared_slope   the largest of all bricks
/// wall            the least of all bricks, voxels; twice the band or more = none
Certificate certificate_from(float squared_slope, float wall, double band);

/// What a checked image says; all zero where it says nothing (version 1.0).
Certificate certificate_of(const FieldView& view);

}  // namespace isotouch::encoding
