// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/boxes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kTorn = 2.5;  // diameters: a contour with such a step lacks drops, and cuts its corners

/// The smallest outline around each, or none.
std::vector<std::size_t> parentsOf(const std::vector<DropContour>& contours) {
  std::vector<double> areas;
  std::vector<Box2> boxes;
  for (const DropContour& contour : contours) {
    areas.push_back(std::abs(signedArea(contour.outline)));
    boxes.push_back(boundingBox({contour.outline}));
  }
  std::vector<std::size_t> parents(contours.size(), kNone);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Point2& point = contours[i].outline.front();
    for (std::size_t j = 0; j < contours.size(); ++j) {
      const bool may_enclose = j != i && areas[j] > areas[i] &&
                               (boxes[j].low.array() <= point.array()).all() &&
                               (boxes[j].high.array() >= point.array()).all();
      if (!may_enclose || (parents[i] != kNone && areas[parents[i]] <= areas[j])) continue;
      if (encloses(contours[j].outline, point)) parents[i] = j;
    }
  }
  return parents;
}

double longestStep(const Polygon& outline) {
  double longest = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    longest = std::max(longest, (outline[(i + 1) % outline.size()] - outline[i]).norm());
  return longest;
}

/// What lies in an outline that lacks drops cannot be determined: such a contour around a hole, with a whole
/// one of a hole in its place, is taken for one of those around that.
void dropTornBorders(std::vector<DropContour>& contours, double diameter) {
  std::vector<Box2> boxes;
  std::vector<bool> is_torn;
  for (const DropContour& contour : contours) {
    boxes.push_back(boundingBox({contour.outline}));
    is_torn.push_back(longestStep(contour.outline) > kTorn * diameter);
  }
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
  const std::vector<std::size_t> parents = parentsOf(contours);
  for (std::size_t i = 0; i < contours.size(); ++i)
    contours[i].is_border = contours[i].is_hole || parents[i] == kNone || contours[parents[i]].is_hole;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (parents[i] == kNone) continue;
    DropContour& parent = contours[parents[i]];
    parent.is_innermost = false;
    if (parent.is_hole && contours[i].is_hole) parent.is_border = false;
  }
  dropTornBorders(contours, layer.diameter_mm);
  return contours;
}

std::vector<Polygon> borders(const std::vector<DropContour>& contours) {
  std::vector<Polygon> found;
  for (const DropContour& contour : contours)
    if (contour.is_border) found.push_back(contour.outline);
  return found;
}

}  // namespace lamina
