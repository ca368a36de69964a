// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/run_path.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "planning/bridges/bridged_areas.hpp"
#include "planning/skins/ironing.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kAside = 0.05;   // bead widths
constexpr double kLongest = 1.0;  // bead widths: of what becomes one motion
constexpr double kWidest = 1.25;  // times the widest bead: more goes back over itself

/// Motions of a run that may become one.
class MotionStretch {
 public:
  MotionStretch(const FillPath& run, double bead_mm) : run_(run), bead_mm_(bead_mm) {}

  /// The last of the points to which the run may go straight from one of them.
  std::size_t end(std::size_t from) const {
    std::size_t to = from + 1;
    while (to + 1 < run_.points.size() && isStraight(from, to + 1)) ++to;
    return to;
  }

  /// With the volume of all motions between.
  double width(std::size_t from, std::size_t to) const {
    if (to == from + 1) return run_.width_mm[to];
    const double way_mm = (run_.points[to] - run_.points[from]).norm();
    double area_mm2 = 0.0;
    for (std::size_t i = from + 1; i <= to; ++i) area_mm2 += areaOf(i);
    return area_mm2 / way_mm;
  }

 private:
  double lengthOf(std::size_t end) const { return (run_.points[end] - run_.points[end - 1]).norm(); }
  double areaOf(std::size_t end) const { return run_.width_mm[end] * lengthOf(end); }

  bool isStraight(std::size_t from, std::size_t to) const {
    const Point2& a = run_.points[from];
    const Point2& b = run_.points[to];
    double way_mm = 0.0;
    for (std::size_t i = from + 1; i <= to; ++i) way_mm += lengthOf(i);
    const auto [least, greatest] =
        std::minmax_element(run_.width_mm.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                            run_.width_mm.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    if (*least == 0.0) return false;  // a gap
    if (way_mm > kLongest * bead_mm_) return false;
    for (std::size_t i = from + 1; i < to; ++i)
      if ((nearestOnSegment(a, b, run_.points[i]) - run_.points[i]).norm() > kAside * bead_mm_) return false;
    return (b - a).norm() > 0.0 && width(from, to) <= kWidest * *greatest;
  }

  const FillPath& run_;
  double bead_mm_;
};

/// Bead widths: a shorter run is a dot.
double leastLength(PathRole role) {
  switch (role) {
    case PathRole::Infill:
      return 2.0;
    case PathRole::InnerWall:
    case PathRole::GapFill:
    case PathRole::Skin:
      return 1.0;
    default:
      return 0.0;
  }
}

bool isDot(const FillPath& run, double bead_mm) {
  if (run.deposit == Deposit::Drops) return false;
  const double least_mm = leastLength(run.role) * bead_mm;
  double length_mm = 0.0;
  for (std::size_t i = 1; i < run.points.size() && length_mm < least_mm; ++i)
    length_mm += (run.points[i] - run.points[i - 1]).norm();
  if (run.is_closed) length_mm += (run.points.front() - run.points.back()).norm();
  return length_mm < least_mm;
}

}  // namespace

FillPath withoutShortMotions(FillPath run, double bead_mm) {
  if (run.width_mm.empty() || run.is_closed || run.deposit == Deposit::Drops) return run;
  const MotionStretch stretch(run, bead_mm);
  Polyline points = {run.points.front()};
  std::vector<double> width_mm = {run.width_mm.front()};
  for (std::size_t from = 0; from + 1 < run.points.size();) {
    const std::size_t to = stretch.end(from);
    points.push_back(run.points[to]);
    width_mm.push_back(stretch.width(from, to));
    from = to;
  }
  run.points = std::move(points);
  run.width_mm = std::move(width_mm);
  return run;
}

std::vector<FillPath> withoutDots(std::vector<FillPath> runs, double bead_mm) {
  runs.erase(std::remove_if(runs.begin(), runs.end(),
                            [bead_mm](const FillPath& run) { return isDot(run, bead_mm); }),
             runs.end());
  return runs;
}

AlongPath<Bead> beadsOf(const std::vector<double>& width_mm, double area_per_width, double height_mm) {
  std::vector<Bead> beads;
  beads.reserve(width_mm.size());
  for (const double width : width_mm) beads.push_back(beadOfArea(width * area_per_width, height_mm));
  return AlongPath<Bead>(std::move(beads));
}

AlongPath<Bead> beadsAlong(const FillPath& run, const PlanSettings& settings, const Bead& nominal,
                           double pitch_mm) {
  if (run.deposit == Deposit::Drops) return Bead{settings.fill.drops.diameter_mm, nominal.height_mm};
  if (run.role == PathRole::Bridge) return threadBead(settings.bridges, nominal);
  if (run.role == PathRole::Ironing) return ironingBead(settings.ironing, nominal.height_mm);
  if (run.width_mm.empty()) return nominal;
  return beadsOf(run.width_mm, crossSection(nominal) / pitch_mm, nominal.height_mm);
}

Path withFlow(Path path, double factor) {
  if (factor == 1.0 || path.role == PathRole::Travel) return path;
  std::vector<Bead> beads = path.bead.values();
  for (Bead& bead : beads) bead = beadOfArea(factor * crossSection(bead), bead.height_mm);
  path.bead = AlongPath<Bead>(std::move(beads));
  return path;
}

ToolpathLayer withoutFlow(ToolpathLayer layer, double factor) {
  for (Path& path : layer.paths)
    if (isPartOfPart(path)) path = withFlow(std::move(path), 1.0 / factor);
  return layer;
}

Path pathAlong(const FillPath& run, AlongPath<Bead> bead, double z_mm, double feed_mm_s) {
  Path path;
  path.role = run.role;
  path.is_closed = run.is_closed;
  path.deposit = run.deposit;
  path.points.reserve(run.points.size());
  for (const Point2& point : run.points) path.points.emplace_back(point.x(), point.y(), z_mm);
  path.bead = std::move(bead);
  path.feed_mm_s = feed_mm_s;
  return path;
}

}  // namespace lamina
