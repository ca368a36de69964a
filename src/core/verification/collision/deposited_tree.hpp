// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/extents.hpp"

namespace lamina {

/// Finds the boxes near a place among the first so many. A node bounds boxes that are deposited one after the
/// other, which lie near each other, so that what is not deposited yet is left out by its place in the order:
/// one tree, never changed, serves all threads. (A tree of collision objects of FCL would have to grow box by
/// box, one per thread, and takes half a kilobyte a box.)
class DepositedTree {
 public:
  /// @param normal  of the layers [bed frame]
  DepositedTree(const std::vector<DepositedBox>& boxes, const Point3& normal);

  /// Calls visit(index, extents of the box) for each box among the first `count` whose extents meet a region,
  /// in the order of deposition, until it returns true.
  /// @param region  `Extents`, or what else has their `meets`
  template <class Region, class Visit>
  void visitMeeting(const Region& region, std::size_t count, const Visit& visit) const {
    if (count > 0) visitNode(levels_.size() - 1, 0, region, count, visit);
  }

 private:
  static constexpr std::size_t kChildren = 4;

  template <class Region, class Visit>
  bool visitNode(std::size_t level, std::size_t node, const Region& region, std::size_t count,
                 const Visit& visit) const;

  std::vector<std::vector<Extents>> levels_;  ///< boxes first, one root last
  std::vector<std::size_t> boxes_per_node_;   ///< of each level
};

template <class Region, class Visit>
bool DepositedTree::visitNode(std::size_t level, std::size_t node, const Region& region, std::size_t count,
                              const Visit& visit) const {
  if (node * boxes_per_node_[level] >= count || !region.meets(levels_[level][node])) return false;
  if (level == 0) return visit(node, levels_[0][node]);
  const std::size_t end = std::min((node + 1) * kChildren, levels_[level - 1].size());
  for (std::size_t child = node * kChildren; child < end; ++child)
    if (visitNode(level - 1, child, region, count, visit)) return true;
  return false;
}

}  // namespace lamina
