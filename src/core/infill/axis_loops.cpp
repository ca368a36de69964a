// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/axis_loops.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr double kSamePoint = 1e-6;  // mm
/// Quarters of the half turn round a tip.
constexpr int kTurnSteps = 4;
/// How far a corner of the loop may lie from the axis, in radii; 0.5 is on a straight line.
constexpr double kFarthestCorner = 0.8;

Point2 leftOf(const Point2& along) { return {-along.y(), along.x()}; }

/// Walks along both sides of each branch, the axis on the left, and at nodes takes the rightmost turn.
class LoopBuilder {
 public:
  explicit LoopBuilder(const MedialAxis& axis) : axis_(axis), is_done_(2 * axis.branches.size()) {
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
      if (run_.points.size() > 2) loops.push_back(std::move(run_));
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

  void add(const Point2& point, double width) {
    if (!run_.points.empty() && (run_.points.back() - point).norm() < kSamePoint) return;
    run_.points.push_back(point);
    run_.width_mm.push_back(width);
  }

  void addCorner(const AxisPoint& before, const AxisPoint& at, const AxisPoint& after) {
    const Point2 normals =
        leftOf((at.point - before.point).normalized()) + leftOf((after.point - at.point).normalized());
    const double size = normals.norm();
    const Point2 right =
        size > 1e-6 ? Point2(-normals / size) : -leftOf((at.point - before.point).normalized());
    const double reach = size > 1e-6 ? std::min(1.0 / size, kFarthestCorner) : 0.5;
    add(at.point + reach * at.radius_mm * right, at.radius_mm);
  }

  void addTurn(const AxisPoint& before, const AxisPoint& tip) {
    const Point2 along = (tip.point - before.point).normalized();
    for (int k = 0; k <= kTurnSteps; ++k) {
      const double angle = M_PI * (static_cast<double>(k) / kTurnSteps - 0.5);
      add(tip.point + 0.5 * tip.radius_mm * (std::cos(angle) * along + std::sin(angle) * leftOf(along)),
          tip.radius_mm);
    }
  }

  void addDisc(const AxisPoint& centre) {
    for (int k = 0; k < 2 * kTurnSteps; ++k) {
      const double angle = M_PI * k / kTurnSteps;
      add(centre.point + 0.5 * centre.radius_mm * Point2(std::cos(angle), std::sin(angle)), centre.radius_mm);
    }
  }

  const MedialAxis& axis_;
  std::vector<std::vector<std::size_t>> leaving_;  ///< halves that start at each node, by angle
  std::vector<bool> is_done_;                      ///< half by half
  FillPath run_;
};

}  // namespace

std::vector<FillPath> axisLoops(const MedialAxis& axis) { return LoopBuilder(axis).build(); }

}  // namespace lamina
