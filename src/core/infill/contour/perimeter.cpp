// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/perimeter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "infill/medial/medial_beads.hpp"
#include "infill/rectilinear/variable_width_runs.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// An area is taken for wide enough if so much of it at most is not, in squared pitches.
constexpr double kNegligible = 0.1;
/// Smaller gaps are not worth a run, in squared pitches.
constexpr double kLeastGap = 0.3;
/// Half of the thickness of gaps that beads reach over anyway, in pitches.
constexpr double kThinnestGap = 0.1;

double beadAlong(const Regions& regions) {
  double sum = 0.0;
  for (const Region& region : regions) {
    sum += perimeter(region.outer);
    for (const Polygon& hole : region.holes) sum += perimeter(hole);
  }
  return sum;
}

/// Whether shrinking took the same from the area everywhere along its border.
bool isWideEverywhere(const Regions& whole, const Regions& shrunk, double distance, double pitch) {
  const double taken = area(whole) - area(shrunk);
  const double alongside = 0.5 * distance * (beadAlong(whole) + beadAlong(shrunk));
  return std::abs(taken - alongside) < kNegligible * pitch * pitch;
}

void addLoops(std::vector<FillPath>& runs, const Regions& centre_lines) {
  for (Polygon& loop : outlines(centre_lines))
    runs.push_back({std::move(loop), true, PathRole::OuterWall, Deposit::Bead, {}});
}

/// Without slivers, and without gaps that are too small.
Regions worthFilling(const Regions& leftover, double pitch) {
  Regions gaps = offset(offset(leftover, -kThinnestGap * pitch), kThinnestGap * pitch);
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(),
                            [&](const Region& gap) { return area({gap}) < kLeastGap * pitch * pitch; }),
             gaps.end());
  return gaps;
}

}  // namespace

PerimeterFill layPerimeters(const Regions& whole, int count, const InfillRequest& request) {
  const double pitch = request.pitch_mm;
  const double depth = count * pitch + 0.5 * narrowestBead(request);
  PerimeterFill fill;
  fill.links = offset(whole, -depth);
  const bool is_wide = isWideEverywhere(whole, fill.links, depth, pitch);
  for (int k = 0; k < count; ++k) {
    const double inset = (k + 0.5) * pitch;
    addLoops(fill.runs, is_wide ? offset(whole, -inset) : offset(fill.links, depth - inset));
  }
  if (is_wide) return fill;
  MedialBeadSettings beads;
  beads.pitch_mm = pitch;
  const Regions gaps = worthFilling(difference(whole, offset(fill.links, depth)), pitch);
  for (FillPath& bead : medialBeads(gaps, beads)) fill.runs.push_back(std::move(bead));
  return fill;
}

}  // namespace lamina
