// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {

/// A straight bead, or a drop, given by the line through the middle of its cross-section [mm, frame of the
/// layers].
struct DepositedBead {
  Point3 start = Point3::Zero();
  Point3 end = Point3::Zero();
  Bead section;
};

/// Whether a path deposits any material.
bool lays(const Path& path);

/// Calls visit(segment) for each segment of a path that is not empty, in order.
template <class Visit>
void forEachBead(const Path& path, const Visit& visit) {
  forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
    if (!segment.isEmpty()) visit(segment);
  });
}

/// All beads in the order in which they are deposited, and where each layer begins among them.
struct DepositedBeads {
  std::vector<DepositedBead> beads;
  std::vector<std::size_t> first_of_layer;  ///< index of a layer's first bead; one more entry than layers
};

DepositedBeads depositedBeads(const Toolpath& toolpath);

}  // namespace lamina
