// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/void_class.hpp"
#include "voids/beads/bead_spans.hpp"
#include "voids/beads/scan_rows.hpp"

namespace lamina {

/// Reports the class of voids that beads leave, by what lies around them:
///
/// | class | around the void |
/// |---|---|
/// | C4 | a corner of the contour of less than 60 degrees within two pitches |
/// | R1 | infill, and a wall or the contour |
/// | between | infill alone |
/// | C2 | walls that go round it and walls that do not |
/// | C1 | one wall, which goes round it |
/// | C3 | any other walls, or none |
class VoidClassifier {
 public:
  /// @param reaches  row by row
  VoidClassifier(const Regions& contour, const ToolpathLayer& layer, const ScanRows& rows,
                 const std::vector<std::vector<BeadSpan>>& reaches);

  /// @param pitch_mm  of the layer's beads
  VoidClass classOf(const Region& area, double pitch_mm) const;

 private:
  std::vector<std::uint32_t> runsAround(const Region& area) const;
  bool liesInSharpCorner(const Polygon& outline, double reach_mm) const;
  bool touchesContour(const Polygon& outline) const;
  bool goesRound(std::uint32_t run, const Point2& point) const;

  const ToolpathLayer& layer_;
  const ScanRows& rows_;
  const std::vector<std::vector<BeadSpan>>& reaches_;
  std::vector<Polygon> contour_;
  std::vector<Point2> sharp_corners_;
};

}  // namespace lamina
