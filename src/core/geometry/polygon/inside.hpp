// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether the straight line from one point to the other stays in the regions. Its ends may lie on an
/// outline, within 1e-4 mm; a line along an outline may go either way.
bool staysInside(const Regions& regions, const Point2& from, const Point2& to);

/// The same of many lines in the same regions: regions apart from where a line begins are not looked at.
class InsideTest {
 public:
  /// `regions` must outlive the test.
  explicit InsideTest(const Regions& regions);

  bool staysInside(const Point2& from, const Point2& to) const;

 private:
  const Regions& regions_;
  std::vector<Box2> boxes_;  ///< round each region
};

}  // namespace lamina
