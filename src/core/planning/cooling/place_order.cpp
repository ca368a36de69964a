// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/place_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lamina {
namespace {

bool overlap(const Box2& a, const Box2& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

bool isOfPart(const Path& path) {
  const RoleKind kind = kindOf(path.role);
  return kind == RoleKind::Wall || kind == RoleKind::Infill;
}

Box2 boxOf(const Path& path, const Eigen::Quaterniond& layers_from_part) {
  Box2 box;
  for (const Point3& point : path.points) box.include((layers_from_part * point).head<2>());
  const double half_mm = 0.5 * path.bead.at(path.points.size() - 1).width_mm;
  box.low.array() -= half_mm;
  box.high.array() += half_mm;
  return box;
}

/// Boxes united until none overlaps another: each with the paths in it.
struct UnitedBoxes {
  std::vector<Box2> boxes;
  std::vector<std::size_t> of_path;  ///< number of the box

  void add(const Box2& own, std::size_t path) {
    Box2 grown = own;
    std::vector<std::size_t> merged;
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t b = 0; b < boxes.size(); ++b) {
        if (boxes[b].isEmpty() || !overlap(boxes[b], grown)) continue;
        grown.include(boxes[b].low);
        grown.include(boxes[b].high);
        boxes[b] = Box2();
        merged.push_back(b);
        has_grown = true;
      }
    }
    if (merged.empty()) {
      merged.push_back(boxes.size());
      boxes.emplace_back();
    }
    const std::size_t kept = *std::min_element(merged.begin(), merged.end());
    boxes[kept] = grown;
    for (std::size_t& of : of_path)
      if (std::find(merged.begin(), merged.end(), of) != merged.end()) of = kept;
    of_path[path] = kept;
  }
};

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

}  // namespace

PlacedLayer placesOf(const ToolpathLayer& layer, const Eigen::Quaterniond& layers_from_part) {
  const std::vector<Path>& paths = layer.paths;
  UnitedBoxes united;
  united.of_path.assign(paths.size(), kNowhere);
  for (std::size_t p = 0; p < paths.size(); ++p)
    if (isOfPart(paths[p])) united.add(boxOf(paths[p], layers_from_part), p);
  PlacedLayer placed;
  std::vector<std::size_t> place_of_box(united.boxes.size(), kNowhere);
  std::size_t before = kNowhere;
  std::size_t begin = 0;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (paths[p].role == PathRole::Travel) continue;
    const std::size_t box = united.of_path[p];
    const bool goes_on = !placed.visits.empty() && box == before;
    if (!goes_on) {
      placed.visits.push_back({begin, p, p});
      if (box != kNowhere && place_of_box[box] == kNowhere) {
        place_of_box[box] = placed.places.size();
        placed.places.push_back({united.boxes[box], {}});
      }
      if (box != kNowhere) placed.places[place_of_box[box]].visits.push_back(placed.visits.size() - 1);
    }
    placed.visits.back().end = begin = p + 1;
    before = box;
  }
  return placed;
}

double leftBeneath(const Box2& box, const PlaceTimes& below) {
  double left_s = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < below.boxes.size(); ++i)
    if (overlap(box, below.boxes[i])) left_s = std::max(left_s, below.left_s[i]);
  return left_s;
}

}  // namespace lamina
