// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/contour_tree.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "geometry/polygon/edge_collapse_inset.hpp"
#include "infill/contour/parted_area.hpp"
#include "infill/contour/straightened.hpp"
#include "infill/medial/narrow_loops.hpp"
#include "infill/medial/sharp_tips.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Loops shorter than this many pitches are points.
constexpr double kShortest = 1.0;
/// Contours may be straightened so far from one to the next, in pitches: the points that offsets leave beside
/// each other would add up.
constexpr double kStraight = 0.005;
/// Spits that are lost from one contour to the next may leave so much open, in squared pitches.
constexpr double kLostSpit = 0.3;
constexpr double kMostContours = 1e5;

double perimeterOf(const Region& region) {
  double sum = 0.0;
  for (const Polygon& outline : outlines({region})) sum += perimeter(outline);
  return sum;
}

/// Whether each edge of the one became an edge of the other: together they then sweep a stripe along the
/// border. A spit too narrow for that sweeps less.
bool sweepsStripe(const Region& from, const Region& to, double distance_mm) {
  if (from.holes.size() != to.holes.size()) return false;
  const double stripe = 0.5 * distance_mm * (perimeterOf(from) + perimeterOf(to));
  return std::abs(area({from}) - area({to}) - stripe) < kLostSpit * distance_mm * distance_mm;
}

/// What becomes of the narrow rests.
enum class RestFill { Loops, None };

class TreeGrower {
 public:
  TreeGrower(const InfillRequest& request, RestFill rest_fill)
      : pitch_(request.pitch_mm),
        spacing_(request.spacing_mm),
        is_solid_(isSolid(request)),
        rest_fill_(rest_fill) {
    tree_.parents.push_back(0);
  }

  OpenContourTree grow(const Region& region) && {
    tree_.border = outlines({region});
    if (is_solid_)
      take(partByWidth({region}, pitch_), 0);
    else
      add(offset({region}, -0.5 * pitch_), 0);
    for (std::size_t i = 0; i < growing_.size(); ++i) {
      const Growing from = std::exchange(growing_[i], {});
      const std::size_t node = addNode(from.centre_lines, from.parent);
      if (is_solid_)
        growSolid(from, node);
      else
        add(offset({from.centre_lines}, -spacing_), node);
    }
    return {std::move(tree_), std::move(rests_)};
  }

 private:
  struct Growing {
    Region centre_lines;
    std::size_t parent = 0;
    std::optional<Region> next;  ///< centre lines, if they are known already
  };

  void add(Regions centre_lines, std::size_t parent) {
    for (Region& each : centre_lines)
      growing_.push_back({straightened(std::move(each), kStraight * pitch_), parent, std::nullopt});
  }

  /// The next contour, if it follows all of this one.
  std::optional<Region> shrunk(const Region& centre_lines) const {
    std::optional<Region> direct = insetByEdgeCollapse(centre_lines, pitch_);
    if (direct) return direct;
    Regions clipped = offset({centre_lines}, -pitch_);
    if (clipped.size() != 1 || !sweepsStripe(centre_lines, clipped.front(), pitch_)) return std::nullopt;
    return straightened(std::move(clipped.front()), kStraight * pitch_);
  }

  void growSolid(const Growing& from, std::size_t node) {
    // What the next contour but one leaves reports whether there is room for the next one everywhere.
    std::optional<Region> next = from.next ? from.next : shrunk(from.centre_lines);
    std::optional<Region> after;
    if (next) after = shrunk(*next);
    if (after && !hasSharpCorner(*after)) {
      growing_.push_back({std::move(*next), node, std::move(after)});
      return;
    }
    const Regions left = offset({from.centre_lines}, -0.5 * pitch_);
    std::optional<PartedArea> parts;
    if (after && left.size() == 1) parts = partByTips(left.front(), *after, pitch_);
    if (parts)
      take(*parts, node);
    else
      for (const Region& each : left) take(partByWidth({each}, pitch_), node);
  }

  void take(const PartedArea& parts, std::size_t parent) {
    add(offset(parts.wide, -0.5 * pitch_), parent);
    for (const Region& narrow : parts.narrow) {
      if (rest_fill_ == RestFill::Loops)
        addLoops(narrow, parent);
      else
        rests_.push_back({narrow, parent});
    }
  }

  void addLoops(const Region& narrow, std::size_t parent) {
    std::vector<ContourLoop> loops = narrowLoops(narrow, pitch_);
    if (loops.empty()) return;
    tree_.parents.push_back(parent);
    for (ContourLoop& loop : loops) {
      loop.node = tree_.parents.size() - 1;
      tree_.loops.push_back(std::move(loop));
    }
  }

  std::size_t addNode(const Region& centre_lines, std::size_t parent) {
    tree_.parents.push_back(parent);
    const std::size_t node = tree_.parents.size() - 1;
    for (const Polygon& outline : outlines({centre_lines}))
      if (perimeter(outline) > kShortest * pitch_)
        tree_.loops.push_back({outline, std::vector<double>(outline.size(), pitch_), node});
    return node;
  }

  double pitch_;
  double spacing_;
  bool is_solid_;
  RestFill rest_fill_;
  ContourTree tree_;
  std::vector<NarrowRest> rests_;
  std::vector<Growing> growing_;
};

}  // namespace

void requireContourSpacing(const Region& region, double spacing) {
  if (!(spacing > 0.0 && std::isfinite(spacing)))
    throw InvalidInput("infill spacing is " + std::to_string(spacing) + " mm; must be positive");
  const Box2 box = boundingBox({region.outer});
  if (!box.isEmpty() && box.size().minCoeff() > kMostContours * spacing)
    throw InvalidInput("infill spacing is " + std::to_string(spacing) + " mm; too small for a region " +
                       std::to_string(box.size().minCoeff()) + " mm across");
}

OpenContourTree openContourTree(const Region& region, const InfillRequest& request) {
  requireContourSpacing(region, request.spacing_mm);
  return TreeGrower(request, RestFill::None).grow(region);
}

ContourTree contourTree(const Region& region, const InfillRequest& request) {
  requireContourSpacing(region, request.spacing_mm);
  return std::move(TreeGrower(request, RestFill::Loops).grow(region).tree);
}

}  // namespace lamina
