// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// How a skeleton path ends.
enum class SkeletonPathEnd {
  Tip,     ///< where the axis does
  Branch,  ///< beside a skeleton path that it branches off
};

/// Branches of an axis that go straight on into each other.
struct SkeletonPath {
  std::vector<AxisPoint> points;  ///< without the first again if closed; one alone if the axis is a point
  bool is_closed = false;
  SkeletonPathEnd start = SkeletonPathEnd::Tip;
  SkeletonPathEnd end = SkeletonPathEnd::Tip;
};

/// Every branch of the axis in one skeleton path: at each node the branches that turn least are joined in
/// pairs, and of an odd number one ends there.
std::vector<SkeletonPath> skeletonPathsOf(const MedialAxis& axis);

}  // namespace lamina
