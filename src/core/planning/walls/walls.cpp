// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "infill/least_gap.hpp"
#include "infill/variable_width/medial_beads.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

/// An area by its local thickness.
struct SplitArea {
  Regions wide;
  Regions narrow;  ///< without slivers
};

/// Thinner places are slivers that rounding leaves, in distances.
constexpr double kSliver = 0.1;
/// Corners may hold so much that is thin, in squared thicknesses.
constexpr double kNarrowCorners = 0.1;

double perimeterOf(const Regions& regions) {
  double sum = 0.0;
  for (const Polygon& outline : outlines(regions)) sum += perimeter(outline);
  return sum;
}

/// Whether the area is thicker than twice the distance everywhere: then shrinking took the same from it all
/// along its border, and no outline vanishes. Only areas are compared, so that it costs next to nothing.
/// @param shrunk         the area shrunk by `distance_mm`
/// @param tolerance_mm2  of what is too narrow
bool isWideEverywhere(const Regions& whole, const Regions& shrunk, double distance_mm, double tolerance_mm2) {
  // A disc of that radius vanishes without a trace in the areas.
  if (outlines(shrunk).size() != outlines(whole).size()) return false;
  const double taken = area(whole) - area(shrunk);
  const double alongside = 0.5 * distance_mm * (perimeterOf(whole) + perimeterOf(shrunk));
  return std::abs(taken - alongside) < tolerance_mm2;
}

/// Reports what is thicker than twice the distance from what is not.
/// @param shrunk     the area shrunk by `distance_mm`
/// @param least_mm2  smaller narrow places are left out
SplitArea splitByThickness(const Regions& whole, const Regions& shrunk, double distance_mm,
                           double least_mm2) {
  SplitArea split;
  split.wide = intersection(offset(shrunk, distance_mm), whole);
  const double sliver = kSliver * distance_mm;
  split.narrow = offset(offset(difference(whole, split.wide), -sliver), sliver);
  split.narrow.erase(std::remove_if(split.narrow.begin(), split.narrow.end(),
                                    [&](const Region& region) { return area({region}) < least_mm2; }),
                     split.narrow.end());
  return split;
}

/// Area [mm²] of what is thinner than this; 0 if that is hardly more than corners.
double areaThinnerThan(const Regions& material, double thickness_mm) {
  const double distance = 0.5 * thickness_mm;
  const Regions shrunk = offset(material, -distance);
  const double tolerance = kNarrowCorners * thickness_mm * thickness_mm;
  if (isWideEverywhere(material, shrunk, distance, tolerance)) return 0.0;
  const double thin = area(difference(material, offset(shrunk, distance)));
  return thin > tolerance ? thin : 0.0;
}

/// In squared pitches: corners may hold as much without being taken for narrow places.
constexpr double kCorners = 0.1;
/// The least gap of those that are seen from outside, in squared pitches.
constexpr double kLeastFin = 0.05;
/// In bead widths: a shorter run in a corner of the outer wall is left out.
constexpr double kLeastRun = 1.0;
/// In squared pitches: a smaller narrow place is left to the lines beside it, such as a corner is.
constexpr double kLeastNarrow = 4.0;

class WallMaker {
 public:
  WallMaker(const Regions& material, const PlanSettings& settings, double pitch_mm, double overlap_mm)
      : material_(material),
        settings_(settings),
        pitch_(pitch_mm),
        // A bead reaches beyond the width it fills: its edge, not that width, ends at the outline.
        beyond_(0.5 * (settings.bead.width_mm - pitch_mm)),
        overlap_(overlap_mm) {}

  Walls make() const {
    Walls walls;
    if (!addAll(walls)) {
      walls = {};
      addOneByOne(walls);
    }
    if (settings_.walls.count == 0) {
      walls.infill = offset(material_, -beyond_);
      walls.unprinted_mm2 = areaThinnerThan(material_, leastThickness());
    }
    return walls;
  }

  /// Lines to and fro in a place less than two beads wide would be mostly turns.
  void takeNarrowInfill(Walls& walls) const {
    const Regions shrunk = offset(walls.infill, -pitch_);
    if (isWideEverywhere(walls.infill, shrunk, pitch_, kLeastNarrow * pitch_ * pitch_)) return;
    const SplitArea split = splitByThickness(walls.infill, shrunk, pitch_, kLeastNarrow * pitch_ * pitch_);
    walls.narrow_infill = beadsAlong(split.narrow, PathRole::GapFill);
    walls.infill = difference(walls.infill, split.narrow);
  }

  FittedArea withoutNarrowGaps(const Regions& inside, Regions sparse) const {
    const double distance = 0.5 * pitch_ + overlap_;
    const double least_mm2 = kLeastNarrow * pitch_ * pitch_;
    const Regions shrunk = offset(inside, -distance);
    if (isWideEverywhere(inside, shrunk, distance, least_mm2)) return {std::move(sparse), {}};
    const Regions narrow = splitByThickness(inside, shrunk, distance, least_mm2).narrow;
    const Regions gaps = narrow.empty() ? narrow : intersection(narrow, sparse);
    if (gaps.empty()) return {std::move(sparse), {}};
    return {difference(sparse, gaps),
            beadsAlong(overlap_ > 0.0 ? offset(gaps, -overlap_) : gaps, PathRole::GapFill)};
  }

 private:
  /// All walls, each from the one before: less to do than one by one. False if there is a narrow place.
  bool addAll(Walls& walls) const {
    const double tolerance = kCorners * pitch_ * pitch_;
    const Regions* before = &material_;
    walls.walls.reserve(static_cast<std::size_t>(settings_.walls.count));
    for (int k = 0; k < settings_.walls.count; ++k) {
      const double distance = k == 0 ? 0.5 * settings_.bead.width_mm : pitch_;
      walls.walls.push_back({offset(*before, -distance), {}});
      if (!isWideEverywhere(*before, walls.walls.back().centre_lines, distance, tolerance)) return false;
      before = &walls.walls.back().centre_lines;
    }
    if (walls.walls.empty()) return true;
    const double distance = 0.5 * pitch_ - overlap_;
    walls.infill = offset(*before, -distance);
    return isWideEverywhere(*before, walls.infill, distance, tolerance);
  }

  void addOneByOne(Walls& walls) const {
    walls.unprinted_mm2 = areaThinnerThan(material_, leastThickness());
    Regions left = offset(material_, -beyond_);
    for (int k = 0; k < settings_.walls.count && !left.empty(); ++k) {
      const Regions inner = offset(left, -pitch_);
      const double least_gap = (k == 0 ? kLeastFin : kLeastGap) * pitch_ * pitch_;
      const SplitArea split = splitByThickness(left, inner, pitch_, least_gap);
      Wall wall{offset(split.wide, -0.5 * pitch_),
                beadsAlong(split.narrow, k == 0 ? PathRole::OuterWall : PathRole::GapFill)};
      if (k == 0 && !wall.centre_lines.empty()) wall.thin = withoutStubs(std::move(wall.thin));
      walls.walls.push_back(std::move(wall));
      left = inner;
    }
    walls.infill = overlap_ > 0.0 ? offset(left, overlap_) : std::move(left);
  }

  /// A run that is shorter than a bead is wide is no more than its two ends, one of which lies in the bead
  /// beside it.
  std::vector<FillPath> withoutStubs(std::vector<FillPath> runs) const {
    const double least_mm = kLeastRun * settings_.bead.width_mm;
    runs.erase(
        std::remove_if(runs.begin(), runs.end(),
                       [&](const FillPath& run) { return !run.is_closed && length(run.points) < least_mm; }),
        runs.end());
    return runs;
  }

  double leastThickness() const { return settings_.walls.narrowest * pitch_ + 2.0 * beyond_; }

  std::vector<FillPath> beadsAlong(const Regions& narrow, PathRole role) const {
    MedialBeadSettings beads;
    beads.pitch_mm = pitch_;
    beads.least_width = settings_.walls.narrowest;
    std::vector<FillPath> runs = medialBeads(narrow, beads);
    for (FillPath& run : runs) run.role = role;
    return runs;
  }

  const Regions& material_;
  const PlanSettings& settings_;
  double pitch_;
  double beyond_;  ///< what a bead reaches beyond the width it fills, on each side [mm]
  double overlap_;
};

}  // namespace

FittedArea fitted(Regions area, const PlanSettings& settings, double pitch_mm) {
  Walls around;
  around.infill = std::move(area);
  const Regions none;
  WallMaker(none, settings, pitch_mm, 0.0).takeNarrowInfill(around);
  return {std::move(around.infill), std::move(around.narrow_infill)};
}

FittedArea withoutNarrowGaps(const Regions& inside, Regions sparse, double overlap_mm,
                             const PlanSettings& settings, double pitch_mm) {
  if (settings.walls.count == 0) return {std::move(sparse), {}};
  const Regions none;
  return WallMaker(none, settings, pitch_mm, overlap_mm).withoutNarrowGaps(inside, std::move(sparse));
}

Walls makeWalls(const Regions& material, const PlanSettings& settings, double pitch_mm, WallContact contact) {
  const bool fits = contact == WallContact::Fitted;
  const bool overlaps = contact == WallContact::Overlapping;
  const double overlap = overlaps ? settings.infill.wall_overlap * settings.bead.width_mm : 0.0;
  const WallMaker maker(material, settings, pitch_mm, overlap);
  Walls walls = maker.make();
  if (fits) maker.takeNarrowInfill(walls);
  return walls;
}

}  // namespace lamina
