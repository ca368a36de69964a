// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/place_order.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/boxes.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

Box2 boxOf(const Path& path, const Eigen::Quaterniond& layers_from_part) {
  Box2 box;
  for (const Point3& point : path.points) box.include((layers_from_part * point).head<2>());
  const double half_mm = 0.5 * path.bead.at(path.points.size() - 1).width_mm;
  box.low.array() -= half_mm;
  box.high.array() += half_mm;
  return box;
}

/// Boxes united until none overlaps another: by sweeps along x over those whose reach along y is apart, until
/// one finds nothing.
class UnitedBoxes {
 public:
  explicit UnitedBoxes(std::vector<Box2> boxes) : boxes_(std::move(boxes)), united_(boxes_.size()) {
    std::iota(united_.begin(), united_.end(), std::size_t{0});
    std::vector<std::size_t> apart = united_;
    for (std::size_t before = 0; before != apart.size();) {
      before = apart.size();
      apart = swept(std::move(apart));
    }
    for (std::size_t box = 0; box < united_.size(); ++box) united_[box] = rootOf(box);
  }

  /// Number of the box that one is united in.
  std::size_t unitedWith(std::size_t box) const { return united_[box]; }
  const Box2& operator[](std::size_t number) const { return boxes_[number]; }

 private:
  /// @return those of the boxes that are left
  std::vector<std::size_t> swept(std::vector<std::size_t> boxes) {
    std::sort(boxes.begin(), boxes.end(), [this](std::size_t a, std::size_t b) {
      return std::make_pair(boxes_[a].low.x(), a) < std::make_pair(boxes_[b].low.x(), b);
    });
    std::map<double, std::size_t> reached;  // by the least y; apart from each other along y
    for (const std::size_t box : boxes) {
      const double x = boxes_[box].low.x();
      for (auto next = reached.upper_bound(boxes_[box].high.y()); next != reached.begin();
           next = reached.upper_bound(boxes_[box].high.y())) {
        const auto other = std::prev(next);
        if (boxes_[other->second].high.y() < boxes_[box].low.y()) break;
        if (boxes_[other->second].high.x() >= x) unite(other->second, box);
        reached.erase(other);
      }
      reached.emplace(boxes_[box].low.y(), box);
    }
    boxes.erase(
        std::remove_if(boxes.begin(), boxes.end(), [this](std::size_t box) { return united_[box] != box; }),
        boxes.end());
    return boxes;
  }

  /// Halves the way there for who comes next.
  std::size_t rootOf(std::size_t box) {
    for (; united_[box] != box; box = united_[box]) united_[box] = united_[united_[box]];
    return box;
  }

  void unite(std::size_t box, std::size_t in) {
    boxes_[in].include(boxes_[box].low);
    boxes_[in].include(boxes_[box].high);
    united_[box] = in;
  }

  std::vector<Box2> boxes_;
  std::vector<std::size_t> united_;
};

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

}  // namespace

PlacedLayer placesOf(const ToolpathLayer& layer, const Eigen::Quaterniond& layers_from_part) {
  const std::vector<Path>& paths = layer.paths;
  std::vector<Box2> boxes;
  std::vector<std::size_t> box_of(paths.size(), kNowhere);
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (!isPartOfPart(paths[p])) continue;
    box_of[p] = boxes.size();
    boxes.push_back(boxOf(paths[p], layers_from_part));
  }
  std::vector<std::size_t> place_of_box(boxes.size(), kNowhere);
  const UnitedBoxes united(std::move(boxes));
  PlacedLayer placed;
  std::size_t before = kNowhere;
  std::size_t begin = 0;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (paths[p].role == PathRole::Travel) continue;
    const std::size_t box = box_of[p] == kNowhere ? kNowhere : united.unitedWith(box_of[p]);
    const bool goes_on = !placed.visits.empty() && box == before;
    if (!goes_on) {
      placed.visits.push_back({begin, p, p});
      if (box != kNowhere && place_of_box[box] == kNowhere) {
        place_of_box[box] = placed.places.size();
        placed.places.push_back({united[box], {}});
      }
      if (box != kNowhere) placed.places[place_of_box[box]].visits.push_back(placed.visits.size() - 1);
    }
    placed.visits.back().end = begin = p + 1;
    before = box;
  }
  return placed;
}

double leftBelow(const Box2& box, const PlaceTimes& below) {
  double left_s = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < below.boxes.size(); ++i)
    if (areOverlapping(box, below.boxes[i])) left_s = std::max(left_s, below.left_s[i]);
  return left_s;
}

}  // namespace lamina
