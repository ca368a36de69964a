// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/piece_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kCrumb = 1e-4;       // of the part's volume
constexpr double kLeastPiece = 1e-3;  // of the part's volume
constexpr double kTipMm = 3.0;        // of the head, within which it may touch what it lays

enum Side : std::uint8_t { kGone, kBelow, kAbove, kSeen };

/// Volume of a node and all that hangs together with it on its side, which is seen then.
struct Clump {
  double volume_mm3 = 0.0;
  double base_mm3 = 0.0;  // within a cell of the plane, on what stays
};

class SidesOfPlane {
 public:
  SidesOfPlane(const CellGraph& cells, const CellsLeft& left, const CuttingPlane& plane)
      : cells_(cells), plane_(plane), side_(left.size(), kGone) {
    for (std::uint32_t node = 0; node < side_.size(); ++node)
      if (left[node] != 0) side_[node] = heightOf(node) > 0.0 ? kAbove : kBelow;
  }

  double heightOf(std::uint32_t node) const { return plane_.heightOf(cells_.middle(node)); }
  std::uint8_t of(std::uint32_t node) const { return side_[node]; }

  Clump seen(std::uint32_t start) {
    const std::uint8_t side = side_[start];
    Clump clump;
    stack_.assign(1, start);
    side_[start] = kSeen;
    while (!stack_.empty()) {
      const std::uint32_t node = stack_.back();
      stack_.pop_back();
      clump.volume_mm3 += cells_.volume(node);
      bool lies_on_rest = false;
      for (const std::uint32_t next : cells_.links(node)) {
        lies_on_rest |= side_[next] == kBelow;
        if (side_[next] != side) continue;
        side_[next] = kSeen;
        stack_.push_back(next);
      }
      if (lies_on_rest && heightOf(node) <= cells_.frame().voxel_mm) clump.base_mm3 += cells_.volume(node);
    }
    return clump;
  }

 private:
  const CellGraph& cells_;
  const CuttingPlane& plane_;
  std::vector<std::uint8_t> side_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace

double lowestClearOfBed(const CellGraph& cells, const CellsLeft& left, const Point3& up,
                        const CutRules& rules) {
  const double cell = cells.frame().voxel_mm;
  const double least = rules.bed_mm + std::max(cell, leastTipHeight(rules.head, up));
  double lowest = -std::numeric_limits<double>::infinity();
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node)
    if (left[node] != 0 && cells.middle(node).z() - 0.5 * cell < least)
      lowest = std::max(lowest, up.dot(cells.middle(node)));
  return lowest;
}

double leastTipHeight(const std::vector<HeadStage>& head, const Point3& up) {
  double least = -std::numeric_limits<double>::infinity();
  const double flat = up.head<2>().norm();
  for (const HeadStage& stage : head)
    least = std::max(least, stage.radius_mm * flat - std::max(kTipMm, stage.from_mm) * up.z());
  return least;
}

TriedCut cutCells(const CellGraph& cells, const CellsLeft& left, const CuttingPlane& plane,
                  const CutRules& rules) {
  if (plane.from_mm < lowestClearOfBed(cells, left, plane.up, rules)) return {CutFault::InBed, {}};
  SidesOfPlane sides(cells, left, plane);
  CutCells cut;
  cut.left = left;
  const double cell = cells.frame().voxel_mm;
  const double whole = rules.part_mm3;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node) {
    if (sides.of(node) != kAbove) continue;
    const Clump clump = sides.seen(node);
    const double base_mm2 = clump.base_mm3 / cell;
    if (base_mm2 < rules.least_base_mm2 && clump.volume_mm3 > kCrumb * whole)
      return {CutFault::SmallBase, {}};
    cut.volume_mm3 += clump.volume_mm3;
    cut.area_mm2 += base_mm2;
  }
  if (cut.volume_mm3 < kLeastPiece * whole) return {CutFault::SmallPiece, {}};
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node)
    if (sides.of(node) == kSeen) cut.left[node] = 0;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node)
    if (sides.of(node) == kBelow && cells.corner(node).z() < rules.bed_mm + cell) sides.seen(node);
  double loose_mm3 = 0.0;
  for (std::uint32_t node = 0; node < cells.nodeCount(); ++node)
    if (sides.of(node) == kBelow) loose_mm3 += cells.volume(node);
  if (loose_mm3 > kCrumb * whole) return {CutFault::LooseRest, {}};
  return {CutFault::None, std::move(cut)};
}

}  // namespace lamina
