// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/skeleton_paths.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Ends of branches are numbered: 2 i where branch i starts, 2 i + 1 where it ends.
class SkeletonPathBuilder {
 public:
  explicit SkeletonPathBuilder(const MedialAxis& axis)
      : axis_(axis), partner_(2 * axis.branches.size(), kNone), is_done_(axis.branches.size()) {
    std::vector<std::vector<std::size_t>> ends(axis.nodes.size());
    for (std::size_t i = 0; i < axis.branches.size(); ++i) {
      ends[axis.branches[i].from].push_back(2 * i);
      ends[axis.branches[i].to].push_back(2 * i + 1);
    }
    for (std::vector<std::size_t>& at : ends) pairUp(at);
    is_tip_.resize(partner_.size());
    for (const std::vector<std::size_t>& at : ends)
      for (const std::size_t end : at)
        is_tip_[end] = at.size() == 1 || axis.branches[end / 2].points.size() == 1;
  }

  std::vector<SkeletonPath> build() {
    std::vector<SkeletonPath> skeleton_paths;
    for (std::size_t end = 0; end < partner_.size(); ++end)
      if (partner_[end] == kNone && !is_done_[end / 2]) skeleton_paths.push_back(follow(end));
    for (std::size_t end = 0; end < partner_.size(); end += 2)
      if (!is_done_[end / 2]) skeleton_paths.push_back(follow(end));
    return skeleton_paths;
  }

 private:
  /// Away from the node.
  Point2 directionOf(std::size_t end) const {
    const std::vector<AxisPoint>& points = axis_.branches[end / 2].points;
    const bool is_start = end % 2 == 0;
    const AxisPoint& node = is_start ? points.front() : points.back();
    // Beside a node the axis may wind; what counts is where it leads out of the disc there.
    Point2 way = Point2::Zero();
    for (std::size_t k = 1; k < points.size(); ++k) {
      way = (is_start ? points[k] : points[points.size() - 1 - k]).point - node.point;
      if (way.norm() > node.radius_mm) break;
    }
    return way.normalized();
  }

  void pairUp(const std::vector<std::size_t>& at) {
    std::vector<Point2> directions;
    directions.reserve(at.size());
    for (const std::size_t end : at) directions.push_back(directionOf(end));
    std::tuple<double, std::size_t, std::size_t> straightest = {1.0, kNone, kNone};
    for (std::size_t a = 0; a < at.size(); ++a)
      for (std::size_t b = a + 1; b < at.size(); ++b)
        straightest = std::min(straightest, {directions[a].dot(directions[b]), at[a], at[b]});
    const auto [turn, a, b] = straightest;
    if (a != kNone) partner_[a] = b, partner_[b] = a;
  }

  SkeletonPath follow(std::size_t start) {
    SkeletonPath skeleton_path;
    skeleton_path.start = is_tip_[start] ? SkeletonPathEnd::Tip : SkeletonPathEnd::Branch;
    std::size_t end = start;
    while (true) {
      append(skeleton_path.points, end);
      is_done_[end / 2] = true;
      const std::size_t far_end = end ^ 1U;
      skeleton_path.end = is_tip_[far_end] ? SkeletonPathEnd::Tip : SkeletonPathEnd::Branch;
      end = partner_[far_end];
      if (end == kNone || is_done_[end / 2]) break;
    }
    skeleton_path.is_closed = end == start && skeleton_path.points.size() > 2;
    if (skeleton_path.is_closed) skeleton_path.points.pop_back();
    return skeleton_path;
  }

  void append(std::vector<AxisPoint>& points, std::size_t end) const {
    std::vector<AxisPoint> more = axis_.branches[end / 2].points;
    if (end % 2 == 1) std::reverse(more.begin(), more.end());
    points.insert(points.end(), more.begin() + (points.empty() ? 0 : 1), more.end());
  }

  const MedialAxis& axis_;
  std::vector<std::size_t> partner_;  ///< of each end
  std::vector<bool> is_tip_;          ///< end by end
  std::vector<bool> is_done_;         ///< branch by branch
};

}  // namespace

std::vector<SkeletonPath> skeletonPathsOf(const MedialAxis& axis) {
  return SkeletonPathBuilder(axis).build();
}

}  // namespace lamina
