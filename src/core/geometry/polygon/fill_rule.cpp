// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/fill_rule.hpp"

#include "geometry/polygon/clipper_units.hpp"

namespace lamina {

Regions enclosed(const std::vector<Polygon>& outlines, FillRule rule) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  for (const Polygon& outline : outlines) {
    requireWithinReach(outline);
    clipper.AddPath(toUnits(outline), ClipperLib::ptSubject, true);
  }
  ClipperLib::PolyTree tree;
  const auto type = rule == FillRule::NonZero ? ClipperLib::pftNonZero : ClipperLib::pftEvenOdd;
  clipper.Execute(ClipperLib::ctUnion, tree, type, type);
  return fromTree(tree);
}

}  // namespace lamina
