// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/boxes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kTorn = 2.5;  // diameters: a contour with such a step lacks drops, and cuts its corners

double longestStep(const Polygon& outline) {
  double longest = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    longest = std::max(longest, (outline[(i + 1) % outline.size()] - outline[i]).norm());
  return longest;
}

std::vector<bool> findTorn(const std::vector<DropContour>& contours, double diameter) {
  std::vector<bool> is_torn;
  is_torn.reserve(contours.size());
  for (const DropContour& contour : contours)
    is_torn.push_back(longestStep(contour.outline) > kTorn * diameter);
  return is_torn;
}

bool enclosesAll(const Polygon& outline, const Polygon& drops) {
  return std::all_of(drops.begin(), drops.end(),
                     [&outline](const Point2& drop) { return encloses(outline, drop); });
}

/// The smallest outline around each, or none. Contours do not cross: one that lacks drops and runs across a
/// whole one does so where it lacks them, and is around that one only if no other is.
std::vector<std::size_t> parentsOf(const std::vector<DropContour>& contours,
                                   const std::vector<bool>& is_torn) {
  std::vector<double> areas;
  std::vector<Box2> boxes;
  for (const DropContour& contour : contours) {
    areas.push_back(std::abs(signedArea(contour.outline)));
    boxes.push_back(boundingBox({contour.outline}));
  }
  std::vector<std::size_t> parents(contours.size(), kNone);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Polygon& inner = contours[i].outline;
    const Point2& point = inner.front();
    std::pair<bool, double> nearest = {true, std::numeric_limits<double>::infinity()};
    for (std::size_t j = 0; j < contours.size(); ++j) {
      const Polygon& outer = contours[j].outline;
      const bool may_enclose = j != i && areas[j] > areas[i] &&
                               (boxes[j].low.array() <= point.array()).all() &&
                               (boxes[j].high.array() >= point.array()).all();
      if (!may_enclose || std::pair(false, areas[j]) >= nearest || !encloses(outer, point)) continue;
      const bool is_crossing = is_torn[j] && !is_torn[i] && !enclosesAll(outer, inner);
      if (std::pair(is_crossing, areas[j]) >= nearest) continue;
      nearest = {is_crossing, areas[j]};
      parents[i] = j;
    }
  }
  return parents;
}

/// What lies in an outline that lacks drops cannot be determined: such a contour around a hole, with a whole
/// one of a hole in its place, is taken for one of those around that.
void dropTornBorders(std::vector<DropContour>& contours, const std::vector<bool>& is_torn) {
  std::vector<Box2> boxes;
  boxes.reserve(contours.size());
  for (const DropContour& contour : contours) boxes.push_back(boundingBox({contour.outline}));
  for (std::size_t i = 0; i < contours.size(); ++i)
    for (std::size_t j = 0; is_torn[i] && contours[i].is_hole && j < contours.size(); ++j)
      if (!is_torn[j] && contours[j].is_hole && contours[j].is_border && areOverlapping(boxes[i], boxes[j]))
        contours[i].is_border = false;
}

Polygon outlineOf(const std::vector<Point2>& drops, const DropChain& chain) {
  return {drops.begin() + static_cast<std::ptrdiff_t>(chain.begin),
          drops.begin() + static_cast<std::ptrdiff_t>(chain.end)};
}

}  // namespace

std::vector<DropContour> contoursOf(const DropLayer& layer) {
  std::vector<DropContour> contours;
  for (std::size_t i = 0; i < layer.chains.size(); ++i) {
    const DropChain& chain = layer.chains[i];
    if (chain.role != DropRole::Contour || chain.end - chain.begin < 3) continue;
    DropContour contour;
    contour.chain = i;
    contour.outline = outlineOf(layer.drops, chain);
    contour.is_hole = signedArea(contour.outline) < 0.0;
    contour.is_innermost = true;
    contours.push_back(std::move(contour));
  }
  const std::vector<bool> is_torn = findTorn(contours, layer.diameter_mm);
  const std::vector<std::size_t> parents = parentsOf(contours, is_torn);
  for (std::size_t i = 0; i < contours.size(); ++i)
    contours[i].is_border = contours[i].is_hole || parents[i] == kNone || contours[parents[i]].is_hole;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (parents[i] == kNone) continue;
    DropContour& parent = contours[parents[i]];
    parent.is_innermost = false;
    if (parent.is_hole && contours[i].is_hole) parent.is_border = false;
  }
  dropTornBorders(contours, is_torn);
  return contours;
}

std::vector<Polygon> borders(const std::vector<DropContour>& contours) {
  std::vector<Polygon> found;
  for (const DropContour& contour : contours)
    if (contour.is_border) found.push_back(contour.outline);
  return found;
}

}  // namespace lamina
