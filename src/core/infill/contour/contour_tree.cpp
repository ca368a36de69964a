// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/contour_tree.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polygon/edge_collapse_inset.hpp"
#include "infill/contour/contour_loop.hpp"
#include "infill/variable_width/axis_loops.hpp"
#include "infill/variable_width/axis_steps.hpp"
#include "infill/variable_width/bead_axis.hpp"
#include "infill/variable_width/sharp_tips.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/polygon/simplify.hpp"

namespace lamina {
namespace {

/// The region without the points that lie within the tolerance of the edge that replaces them; as it is where
/// its outlines would vanish or come apart so.
Region straightened(Region region, double tolerance_mm) {
  const std::vector<Polygon> whole = outlines({region});
  const std::vector<Polygon> simple = simplify(whole, tolerance_mm);
  if (simple == whole) return region;
  Regions straight = unite(simple);
  return straight.size() == 1 ? std::move(straight.front()) : std::move(region);
}

/// Thickness below which nothing is deposited, in pitches.
constexpr double kLeastWidth = 0.3;
/// So far the border may be straightened before its axis is sought, in pitches.
constexpr double kStraightRest = 0.02;
/// By how much the radius may change within one motion, in pitches.
constexpr double kWidthStep = 0.05;
/// Smaller regions are left out, in squared pitches.
constexpr double kLeastRest = 0.2;
/// Loops shorter than this many pitches are points.
constexpr double kShortest = 1.0;
/// Of regions that are filled along their border, in pitches: the corners of thinner ones are in the way of
/// links.
constexpr double kLeastRadius = 0.6;
/// How much of a region's area a loop along its border may lay.
constexpr double kMostFilled = 1.06;
/// What a loop along the border may leave open in one place, in squared pitches.
constexpr double kLargestScrap = 0.2;

double largestRadius(const MedialAxis& axis) {
  double largest = 0.0;
  for (const AxisBranch& branch : axis.branches)
    for (const AxisPoint& point : branch.points) largest = std::max(largest, point.radius_mm);
  return largest;
}

/// Whether a bead along the border, of a width that is also the largest disc's radius, leaves nothing open
/// but scraps: where the region is thinner than the bead is wide, no centre line is left.
bool reachesAll(const Region& region, const Regions& centre_lines, double radius, double pitch_mm) {
  const Regions left = difference({region}, offset(centre_lines, 0.5 * radius));
  return std::all_of(left.begin(), left.end(),
                     [&](const Region& each) { return area({each}) < kLargestScrap * pitch_mm * pitch_mm; });
}

/// One loop along the border, half as wide as the largest disc inside. None if it would lay too much or would
/// not reach everything, because the region is narrower elsewhere.
std::optional<ContourLoop> borderLoop(const Region& region, double radius, double pitch_mm) {
  const Regions centre_lines = offset({region}, -0.5 * radius);
  if (centre_lines.size() != 1 || !centre_lines.front().holes.empty()) return std::nullopt;
  ContourLoop loop;
  loop.points = centre_lines.front().outer;
  if (perimeter(loop.points) * radius > kMostFilled * area({region})) return std::nullopt;
  if (!reachesAll(region, centre_lines, radius, pitch_mm)) return std::nullopt;
  loop.width_mm.assign(loop.points.size(), radius);
  return loop;
}

/// Closed loops that fill a narrow region by beads half as wide as it is, out along one side of its medial
/// axis and back along the other: one loop round each connected axis and one more in each of its holes. Where
/// the region is about as thick all over, and without holes, the loop runs along its border.
std::vector<ContourLoop> narrowLoops(const Region& region, double pitch_mm) {
  if (area({region}) < kLeastRest * pitch_mm * pitch_mm) return {};
  MedialBeadSettings settings;
  settings.pitch_mm = pitch_mm;
  settings.least_width = kLeastWidth;
  MedialAxis axis = beadAxis(straightened(region, kStraightRest * pitch_mm), settings);
  const double radius = largestRadius(axis);
  if (radius > kLeastRadius * pitch_mm)
    if (std::optional<ContourLoop> loop = borderLoop(region, radius, pitch_mm)) return {std::move(*loop)};
  for (AxisBranch& branch : axis.branches)
    branch.points = inRadiusSteps(branch.points, kWidthStep * pitch_mm);
  std::vector<ContourLoop> loops;
  for (FillPath& path : axisLoops(axis, region)) {
    if (perimeter(path.points) < kShortest * pitch_mm) continue;
    ContourLoop loop;
    loop.points = std::move(path.points);
    loop.width_mm = std::move(path.width_mm);
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// An area parted by how much room it has for beads side by side.
struct PartedArea {
  Regions wide;    ///< what a bead along the border fills and leaves a pitch of thickness at least
  Regions narrow;  ///< the rest, without hairs along the border
};

/// How much narrower than an area its core is on each side, in pitches: where there is core, it is wide.
constexpr double kCoreDepth = 1.5;

/// Of the narrow rest, what is thinner than twice this is left out, in pitches.
constexpr double kHair = 0.1;

/// What is too small to hold a disc need not be shrunk to find that nothing is left.
Regions withRoomFor(Regions regions, double radius_mm) {
  const double least_area = M_PI * radius_mm * radius_mm;
  regions.erase(std::remove_if(regions.begin(), regions.end(),
                               [&](const Region& each) { return area({each}) < least_area; }),
                regions.end());
  return regions;
}

/// Parts an area that the functions of `offset.hpp` returned.
PartedArea partByWidth(const Regions& area, double pitch_mm) {
  const Regions core = offset(area, -kCoreDepth * pitch_mm);
  if (core.empty()) return {{}, area};
  const Regions grown = offset(core, kCoreDepth * pitch_mm);
  // Rounding leaves hairs along the border: they are cleared away.
  const double hair_mm = kHair * pitch_mm;
  const Regions narrow = offset(withRoomFor(difference(area, grown), hair_mm), -hair_mm);
  if (narrow.empty()) return {area, {}};
  return {intersection(grown, area), offset(narrow, hair_mm)};
}

/// Parts an area that shrinks as a whole to `core`, `kCoreDepth` pitches from its border: nothing of it is
/// narrow then but the tips of sharp corners. Nothing where they are not that simple to cut.
std::optional<PartedArea> partByTips(const Region& area, const Region& core, double pitch_mm) {
  std::optional<TipCut> cut = cutSharpTips(area, core, kCoreDepth * pitch_mm);
  if (!cut) return std::nullopt;
  const Regions narrow = offset(cut->tips, -kHair * pitch_mm);
  return PartedArea{{std::move(cut->rest)}, offset(narrow, kHair * pitch_mm)};
}

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
    // What the next contour but one leaves shows whether there is room for the next one everywhere.
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
    throw InvalidInput("infill spacing is " + numberText(spacing) + " mm; must be positive");
  const Box2 box = boundingBox({region.outer});
  if (!box.isEmpty() && box.size().minCoeff() > kMostContours * spacing)
    throw InvalidInput("infill spacing is " + numberText(spacing) + " mm; too small for a region " +
                       numberText(box.size().minCoeff()) + " mm across");
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
