// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/bead_axis.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "geometry/medial_axis/axis_graph.hpp"
#include "geometry/polygon/chain_splitting.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// Corners and edges of the region make the axis wind; so far it may be straightened, in pitches.
constexpr double kTolerance = 0.01;
/// In pitches; the end of a bead covers what reaches less beyond it.
constexpr double kLeastReach = 0.5;
/// A round end leaves 0.4 of its squared radius open in such a corner.
constexpr double kWidestCorner = toRadians(75.0);
/// Wider ones are bends of the border.
constexpr double kBend = toRadians(120.0);

AxisPoint whereRadiusIs(const AxisPoint& a, const AxisPoint& b, double radius) {
  const double t = (radius - a.radius_mm) / (b.radius_mm - a.radius_mm);
  return {a.point + t * (b.point - a.point), radius};
}

/// Without points that are out of the way between their neighbours by less than the tolerance, the radius a
/// coordinate like the others.
std::vector<AxisPoint> straightened(const std::vector<AxisPoint>& points, double tolerance) {
  const auto at = [&](std::size_t i) {
    return Point3(points[i].point.x(), points[i].point.y(), points[i].radius_mm);
  };
  std::vector<AxisPoint> kept;
  for (const std::size_t i : keptOfChain(0, points.size() - 1, [&](std::size_t from, std::size_t to) {
         return farthestBetween(from, to, tolerance, at);
       }))
    kept.push_back(points[i]);
  return kept;
}

/// Takes the axis over as far as it is thick enough.
class ThickParts {
 public:
  ThickParts(const MedialAxis& axis, double least_radius, double tolerance)
      : least_radius_(least_radius), tolerance_(tolerance), graph_(axis.nodes.size()) {
    for (const AxisBranch& branch : axis.branches) take(branch);
  }

  MedialAxis joined() && { return std::move(graph_).joined(); }

 private:
  bool isThick(const AxisPoint& point) const { return point.radius_mm >= least_radius_; }

  void take(const AxisBranch& branch) {
    std::vector<AxisPoint> part;
    std::size_t from = branch.from;
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const AxisPoint& point = branch.points[i];
      const bool crosses = i > 0 && isThick(branch.points[i - 1]) != isThick(point);
      if (crosses) part.push_back(whereRadiusIs(branch.points[i - 1], point, least_radius_));
      if (crosses && !isThick(point)) add(from, graph_.addVertex(), part);
      if (crosses && isThick(point)) from = graph_.addVertex();
      if (isThick(point)) part.push_back(point);
    }
    if (!part.empty()) add(from, branch.to, part);
  }

  void add(std::size_t from, std::size_t to, std::vector<AxisPoint>& part) {
    graph_.add(from, to, straightened(part, tolerance_));
    part.clear();
  }

  double least_radius_;
  double tolerance_;
  AxisGraph graph_;
};

bool isPoint(const MedialAxis& axis) {
  return axis.branches.size() == 1 && axis.branches.front().points.size() == 1;
}

/// Where one branch is all, its ends cost no run: they are kept. What is about as long as wide has nothing
/// but ends: two of them are.
MedialAxis withoutWorthlessEnds(const MedialAxis& axis, double pitch) {
  MedialAxis unbent = pruned(axis, {0.0, kBend});
  if (isPoint(unbent)) return farthestWay(axis);
  if (unbent.branches.size() == 1) return unbent;
  MedialAxis rest = pruned(unbent, {kLeastReach * pitch, kWidestCorner});
  return isPoint(rest) ? farthestWay(unbent) : rest;
}

}  // namespace

MedialAxis beadAxis(const Region& region, const MedialBeadSettings& settings) {
  const double pitch = settings.pitch_mm;
  const MedialAxis axis = withoutWorthlessEnds(medialAxis(region, kTolerance * pitch), pitch);
  return ThickParts(axis, 0.5 * settings.least_width * pitch, kTolerance * pitch).joined();
}

void requirePitch(const MedialBeadSettings& settings) {
  if (!(settings.pitch_mm > 0.0))
    throw InvalidInput("pitch of medial beads is " + numberText(settings.pitch_mm) + " mm; must be positive");
}

}  // namespace lamina
