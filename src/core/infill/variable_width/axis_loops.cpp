// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/axis_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kSamePoint = 1e-6;  // mm
/// Quarters of the half turn round a tip.
constexpr int kTurnSteps = 4;
/// How far a corner of the loop may lie from the axis, in radii; 0.5 is on a straight line.
constexpr double kFarthestCorner = 0.8;
/// A bead has room where the border is this part of half its width away.
constexpr double kRoom = 0.97;
/// Halvings of the way into a corner.
constexpr int kTrials = 5;

/// By how much the radius grows along the axis.
double slopeOf(const AxisPoint& from, const AxisPoint& to) {
  return std::clamp((to.radius_mm - from.radius_mm) / (to.point - from.point).norm(), -1.0, 1.0);
}

/// Where the disc that rolls from one point to the other touches the border on the right: it is at right
/// angles to the axis only where the radius does not change.
Point2 wayToBorder(const AxisPoint& from, const AxisPoint& to) {
  const Point2 along = (to.point - from.point).normalized();
  const double slope = slopeOf(from, to);
  return -slope * along - std::sqrt(1.0 - slope * slope) * leftOf(along);
}

/// Walks along both sides of each branch, the axis on the left, and at nodes takes the rightmost turn.
class LoopBuilder {
 public:
  LoopBuilder(const MedialAxis& axis, const Region& region)
      : axis_(axis), region_(region), is_done_(2 * axis.branches.size()) {
    leaving_.resize(axis.nodes.size());
    for (std::size_t half = 0; half < is_done_.size(); ++half) leaving_[startOf(half)].push_back(half);
    for (std::vector<std::size_t>& at : leaving_)
      std::sort(at.begin(), at.end(), [this](std::size_t a, std::size_t b) {
        return std::make_pair(angleOf(a), a) < std::make_pair(angleOf(b), b);
      });
  }

  std::vector<FillPath> build() {
    std::vector<FillPath> loops;
    for (std::size_t half = 0; half < is_done_.size(); ++half) {
      if (is_done_[half]) continue;
      run_ = {};
      run_.is_closed = true;
      run_.role = PathRole::GapFill;
      for (std::size_t at = half; !is_done_[at]; at = follow(at)) {
      }
      if (run_.points.size() > 1 && (run_.points.back() - run_.points.front()).norm() < kSamePoint) {
        run_.points.pop_back();
        run_.width_mm.front() = run_.width_mm.back();
        run_.width_mm.pop_back();
      }
      if (run_.points.size() < 3) continue;
      takeWidthsOnTheWay();
      loops.push_back(std::move(run_));
    }
    return loops;
  }

 private:
  // Half 2 i runs along branch i, half 2 i + 1 back.
  const AxisBranch& branchOf(std::size_t half) const { return axis_.branches[half / 2]; }
  std::size_t startOf(std::size_t half) const {
    return half % 2 == 0 ? branchOf(half).from : branchOf(half).to;
  }
  std::vector<AxisPoint> pointsOf(std::size_t half) const {
    std::vector<AxisPoint> points = branchOf(half).points;
    if (half % 2 == 1) std::reverse(points.begin(), points.end());
    return points;
  }
  double angleOf(std::size_t half) const {
    const std::vector<AxisPoint> points = pointsOf(half);
    if (points.size() < 2) return 0.0;
    const Point2 along = points[1].point - points[0].point;
    return std::atan2(along.y(), along.x());
  }

  /// The half branch after this one, counter-clockwise round its end from where it came: the rightmost turn.
  std::size_t next(std::size_t half) const {
    const std::vector<std::size_t>& at = leaving_[startOf(half ^ 1U)];
    const std::size_t back =
        static_cast<std::size_t>(std::find(at.begin(), at.end(), half ^ 1U) - at.begin());
    return at[(back + 1) % at.size()];
  }

  std::size_t follow(std::size_t half) {
    is_done_[half] = true;
    const std::vector<AxisPoint> points = pointsOf(half);
    if (points.size() == 1) return addDisc(points[0]), is_done_[half ^ 1U] = true, half;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) addCorner(points[i - 1], points[i], points[i + 1]);
    const std::size_t after = next(half);
    if (after == (half ^ 1U))
      addTurn(points[points.size() - 2], points.back());
    else
      addCorner(points[points.size() - 2], points.back(), pointsOf(after)[1]);
    return after;
  }

  /// So far each width is that at the point.
  void takeWidthsOnTheWay() {
    double before = run_.width_mm.back();
    for (double& width : run_.width_mm) width = 0.5 * (std::exchange(before, width) + width);
  }

  void add(const Point2& point, double width) {
    if (!run_.points.empty() && (run_.points.back() - point).norm() < kSamePoint) return;
    run_.points.push_back(point);
    run_.width_mm.push_back(width);
  }

  void addCorner(const AxisPoint& before, const AxisPoint& at, const AxisPoint& after) {
    const Point2 ways = wayToBorder(before, at) + wayToBorder(at, after);
    const double size = ways.norm();
    const Point2 right = size > 1e-6 ? Point2(ways / size) : wayToBorder(before, at);
    const double reach = size > 1e-6 ? std::min(1.0 / size, kFarthestCorner) : 0.5;
    add(at.point + reach * at.radius_mm * right, at.radius_mm);
  }

  void addTurn(const AxisPoint& before, const AxisPoint& tip) {
    const Point2 along = (tip.point - before.point).normalized();
    const double half_turn = std::acos(-slopeOf(before, tip));
    for (int k = 0; k <= kTurnSteps; ++k) {
      const double angle = half_turn * (2.0 * k / kTurnSteps - 1.0);
      const Point2 way = std::cos(angle) * along + std::sin(angle) * leftOf(along);
      add(tip.point + (2 * k % kTurnSteps == 0 ? 0.5 * tip.radius_mm : reachInto(tip, way)) * way,
          tip.radius_mm);
    }
  }

  /// How far a bead half as wide as the disc round a tip finds room on the way to a corner.
  double reachInto(const AxisPoint& tip, const Point2& way) const {
    double free = 0.5 * tip.radius_mm;
    double beyond = M_SQRT1_2 * tip.radius_mm;
    double tried = beyond;
    for (int i = 0; i < kTrials; ++i) {
      const bool has_room = distanceToBorder(tip.point + tried * way) > kRoom * 0.5 * tip.radius_mm;
      (has_room ? free : beyond) = tried;
      tried = 0.5 * (free + beyond);
    }
    return free;
  }

  double distanceToBorder(const Point2& point) const {
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const Polygon& outline) {
      for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Point2 along = outline[i] - outline[j];
        const double squared = along.squaredNorm();
        const double t =
            squared > 0.0 ? std::clamp((point - outline[j]).dot(along) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, (outline[j] + t * along - point).squaredNorm());
      }
    };
    look(region_.outer);
    for (const Polygon& hole : region_.holes) look(hole);
    return std::sqrt(least);
  }

  void addDisc(const AxisPoint& centre) {
    for (int k = 0; k < 2 * kTurnSteps; ++k) {
      const double angle = M_PI * k / kTurnSteps;
      add(centre.point + 0.5 * centre.radius_mm * Point2(std::cos(angle), std::sin(angle)), centre.radius_mm);
    }
  }

  const MedialAxis& axis_;
  const Region& region_;
  std::vector<std::vector<std::size_t>> leaving_;  ///< halves that start at each node, by angle
  std::vector<bool> is_done_;                      ///< half by half
  FillPath run_;
};

}  // namespace

std::vector<FillPath> axisLoops(const MedialAxis& axis, const Region& region) {
  return LoopBuilder(axis, region).build();
}

}  // namespace lamina
