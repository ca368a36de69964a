// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether the straight line between two points stays in the regions. Its ends may lie on an outline, within
/// 1e-4 mm. For a line along an outline the result may be either.
bool staysInside(const Regions& regions, const Point2& from, const Point2& to);

/// Tests many lines in the same regions (`staysInside`). A region is examined only if the line begins in its
/// bounding box, and a hole only if the line enters its bounding box.
class InsideTest {
 public:
  /// @param regions  must outlive the object
  explicit InsideTest(const Regions& regions);

  bool staysInside(const Point2& from, const Point2& to) const;

 private:
  struct Boxes {
    Box2 outer;
    std::vector<Box2> holes;
  };

  bool isInside(std::size_t region, const Point2& point) const;

  const Regions& regions_;
  std::vector<Boxes> boxes_;  ///< of each region, a little wider than its outlines
};

}  // namespace lamina
