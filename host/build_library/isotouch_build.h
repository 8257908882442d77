/**
 * @file isotouch_build.h
 * Makes fields out of oriented points. A library of its own on top of isotouch.h, whose rules on units, errors and sizes hold here, too.
 */
#ifndef ISOTOUCH_BUILD_H
#define ISOTOUCH_BUILD_H

#include <stddef.h>
#include <stdint.h>

#include <isotouch.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a field is built; the same choices as those of `isotouch build`. */
typedef struct isotouch_build_options {
  double voxel_mm;             /**< edge of a voxel; 0: see grid */
  double band;                 /**< half width of the stored layer, voxels: 1 to 7.99; 3 unless set */
  double stiffness_n_mm;       /**< of the surface; where the points have their own, the largest. 0: theirs, or 0.8 */
  double fit_mm;               /**< length that the longest side is scaled to: 1 to 1000; 70 unless set */
  double mm_per_unit;          /**< instead: the true size, 1 for points in mm, 1000 for metres; 0: fit_mm */
  double viewpoint[3];         /**< the sensor's place in the points' frame: every normal is turned towards it */
  uint32_t has_viewpoint;      /**< 1: viewpoint is set */
  uint32_t grid;               /**< voxels along the longest side: 8 to 4000; 0: as fine as the scan supports */
  uint32_t interpolation;      /**< #isotouch_interpolation */
  uint32_t threads;            /**< at most 1024; 0: one for each processor. The field does not depend on it */
  uint32_t accept_implausible; /**< 1: a field that is judged to be probably wrong is made all the same */
  uint32_t reserved;           /**< 0 */
} isotouch_build_options;

/**
 * Sets every member to its default.
 *
 * @param size  sizeof(isotouch_build_options)
 */
ISOTOUCH_API isotouch_status isotouch_build_default(isotouch_build_options* options, size_t size);

/**
 * Builds a field from a scan, as `isotouch build` does, and checks it as isotouch_field_read() does. The same points give the same field on every machine.
 *
 * @param count      number of points, at least 8
 * @param points     3 × count numbers, finite; any unit and frame, see scale and offset of isotouch_field_facts
 * @param normals    3 × count numbers, outward, of a length from 1/2 to 2. Null: they are estimated from the points
 * @param stiffness  count numbers, N/mm, above 0, at most 100. Null: one for all
 * @param options    null: the defaults
 * @param size       sizeof(isotouch_build_options); 0 where options is null
 * @param field      receives the handle
 * @param warnings   receives one sentence a line about what was put right or looks doubtful, cut where it does not fit. Null where room is 0
 * @param room       bytes of it
 *
 * Refused (#ISOTOUCH_BAD_DATA) is a scan of which no plausible field comes, with every reason. Real time: no; takes seconds, and threads.
 */
ISOTOUCH_API isotouch_status isotouch_build(size_t count, const double* points, const double* normals, const double* stiffness,
                                            const isotouch_build_options* options, size_t size, isotouch_field* field, char* warnings,
                                            size_t room);

#ifdef __cplusplus
}
#endif

#endif
