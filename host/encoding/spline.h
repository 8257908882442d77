/// Distances → the coefficients of the quadratic B-spline that takes those distances at the samples (SPEC.md 2.1).
///
/// A spline whose coefficients are the samples themselves is a blurred field: B = [1/8, 6/8, 1/8] along each axis. Its zero lies
/// 0.003 voxel off on a sphere of 80 voxels and up to 1.8 off along edges. The coefficients are therefore found by c ← c + (φ − B c), begun
/// at c = φ.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/encoding/apron.h"
#include "host/field/band_field.h"

namespace isotouch::encoding {

/// One brick of coefficients, voxels with 12 fraction bits, x fastest.
using Coefficients = std::array<std::int16_t, 64>;

/// Chosen by the offset of the spline's zero along the normal; rms voxels, exact distances, ±4 voxels, random phase, 20,000 points,
/// 2026-11:
///
///     steps                   0         1         2         3         4        12
///     sphere R 80          0.00313   0.00003   0.00003   0.00003   0.00003   0.00003
///     torus 70/25          0.00516   0.00003   0.00003   0.00004   0.00003   0.00003
///     box 80×60×40         0.0670    0.0297    0.0253    0.0238    0.0231    0.0224
///     plate 80×60×2        0.0842    0.0369    0.0317    0.0299    0.0291    0.0282
///     box, turned          0.0659    0.0303    0.0267    0.0258    0.0255    0.0255
inline constexpr int kSplineSteps = 3;

/// field     bricks sorted by cell. Samples with |distance| <= band are true distances; beyond, only the sign counts and they become ±band
/// around    its `neighbours`
/// steps     how often the difference to the samples is taken back; 0 keeps the samples
/// returns   one brick for each of the field's, in their order, clamped to ±band. A sample is corrected only where all its 26 neighbours
/// are
///           within the band, so that the kink at its end is left alone; from a band of 3 voxels on the zero surface is out of its reach
/// fails     never
/// source    B-spline interpolation as a digital filter: Unser, Aldroubi and Eden, IEEE Trans. Signal Processing 41(2), 1993; here its
/// Neumann
///           series, because it needs no neighbour further than one brick and no boundary condition
std::vector<Coefficients> spline_coefficients(const field::BandField& field, const std::vector<Neighbours>& around,
                                              int steps = kSplineSteps);

}  // namespace isotouch::encoding
