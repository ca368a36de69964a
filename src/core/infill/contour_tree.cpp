// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour_tree.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/geometry/offset.hpp"

namespace lamina {
namespace {

/// Loops shorter than this many pitches are points.
constexpr double kShortest = 1.0;
constexpr double kMostContours = 1e5;

void refuseTooManyContours(const Region& region, double spacing) {
  if (!(spacing > 0.0 && std::isfinite(spacing)))
    throw InvalidInput("infill spacing is " + std::to_string(spacing) + " mm; must be positive");
  const Box2 box = boundingBox({region.outer});
  if (!box.isEmpty() && box.size().minCoeff() > kMostContours * spacing)
    throw InvalidInput("infill spacing is " + std::to_string(spacing) + " mm; too small for a region " +
                       std::to_string(box.size().minCoeff()) + " mm across");
}

class TreeGrower {
 public:
  explicit TreeGrower(const InfillRequest& request) : request_(request) { tree_.parents.push_back(0); }

  ContourTree grow(const Region& region) && {
    std::vector<Growing> growing;
    const auto add = [&](Regions centre_lines, std::size_t parent) {
      for (Region& each : centre_lines) growing.push_back({std::move(each), parent});
    };
    add(offset({region}, -0.5 * request_.pitch_mm), 0);
    for (std::size_t i = 0; i < growing.size(); ++i) {
      const std::size_t node = addNode(growing[i].centre_lines, growing[i].parent);
      add(offset({std::exchange(growing[i].centre_lines, {})}, -request_.spacing_mm), node);
    }
    return std::move(tree_);
  }

 private:
  struct Growing {
    Region centre_lines;
    std::size_t parent;
  };

  std::size_t addNode(const Region& centre_lines, std::size_t parent) {
    tree_.parents.push_back(parent);
    const std::size_t node = tree_.parents.size() - 1;
    for (const Polygon& outline : outlines({centre_lines}))
      if (perimeter(outline) > kShortest * request_.pitch_mm)
        tree_.loops.push_back({outline, std::vector<double>(outline.size(), request_.pitch_mm), node});
    return node;
  }

  const InfillRequest& request_;
  ContourTree tree_;
};

}  // namespace

ContourTree contourTree(const Region& region, const InfillRequest& request) {
  refuseTooManyContours(region, request.spacing_mm);
  return TreeGrower(request).grow(region);
}

}  // namespace lamina
