// Numbers behind the patch of a pair: how facets are fitted, which normal is taken, how long a patch is kept.
#pragma once

#include "core/constant.h"

namespace carom::collision {

inline constexpr Constant<Real> kFirstTilt{
    "facet_tilt", 0.03, "rad",
    "tilt of the first ring of support calls: above the error of a query's normal, below the angle to the next face; "
    "what encloses less is taken for one face",
    "smaller: a face is found in parts where the normal is 0.02 rad off, and what rests on it rocks; larger: faces "
    "that meet at a blunt edge are taken for one curved face"};
/// Cosine of twice the first tilt, to its fourth order: the farthest that a fitted plane or a crossing of edges lies
/// from the normal of the query. Less, and planes that span several facets are taken for faces; more, and normals that
/// a query has a little wrong lose the face they mean.
inline constexpr Real kPatchSamePlane = 1 - 2 * kFirstTilt * kFirstTilt;

// By how much a normal further down the list (A's face, B's, crossing edges, the query's own) must separate better to
// be taken: resting shapes have several normals equal up to the tilt of a jitter.
inline constexpr Constant<Real> kPatchPreferRelative{
    "patch_prefer_relative", 0.02, "1",
    "share of the separation by which another normal must be better to be taken, between boxes as well: more than "
    "resting shapes jitter",
    "smaller: the patch of what rests changes from step to step, and warm starts are lost; larger: edges sink in "
    "before they are seen as edges"};
inline constexpr Constant<Real> kPatchPreferAbsolute{
    "patch_prefer_absolute", 5e-4, "1",
    "share of the smaller bounding radius by which another normal must be better, beside that of the separation: what "
    "rests is nearly without separation, of which any share is nothing",
    "smaller: normals of what just touches flicker; larger: small overlaps are pushed apart along the wrong face"};

inline constexpr Constant<Real> kKeepRadius{
    "patch_keep_radius", 0.01, "1",
    "share of the smaller bounding radius that two bodies may move before their patch is looked for anew, where that is less than "
    "keep_distance: of small bodies corners move by less than a patch is wide",
    "larger: small bodies tip over corners that have gone; smaller: what is small and rests pays for a query in every "
    "step"};

inline constexpr Constant<Real> kStandsOut{
    "patch_stands_out", 0.02, "1",
    "share of the width of a patch's four points by which another stands out from between them that is a corner of its "
    "own: more than points along an edge do, less than those of a rim between four others (0.1)",
    "smaller: a box with points along its edges spins like a disc; larger: hulls of many sides spin like a box"};

inline constexpr ConstantRow kPatchConstants[] = {kFirstTilt, kPatchPreferRelative, kPatchPreferAbsolute, kKeepRadius,
                                                  kStandsOut};

}  // namespace carom::collision
