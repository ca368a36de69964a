// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// How a skeleton path ends.
enum class SkeletonPathEnd {
  Tip,     ///< where the axis ends
  Branch,  ///< beside another skeleton path, from which it branches off
};

/// A sequence of branches of an axis that continue each other straight on.
struct SkeletonPath {
  /// A closed path does not repeat the first point; a single point if the axis is a point.
  std::vector<AxisPoint> points;
  bool is_closed = false;
  SkeletonPathEnd start = SkeletonPathEnd::Tip;
  SkeletonPathEnd end = SkeletonPathEnd::Tip;
};

/// Divides all branches of the axis among skeleton paths: at each node, branches that continue each other
/// most straightly are joined in pairs; if their number is odd, one ends there.
std::vector<SkeletonPath> skeletonPathsOf(const MedialAxis& axis);

}  // namespace lamina
