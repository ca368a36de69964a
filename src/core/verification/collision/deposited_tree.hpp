// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/extents.hpp"

namespace lamina {

/// Finds boxes near a place among those deposited so far. A node of the tree bounds consecutive boxes in the
/// order of deposition, which are close to each other. Boxes that are not deposited yet are excluded by their
/// index: one immutable tree serves all threads. (A tree of FCL's collision objects would have to grow box by
/// box, one tree per thread, and needs half a kilobyte for each box.)
class DepositedTree {
 public:
  /// @param normal  normal of the layers [bed frame]
  DepositedTree(const std::vector<DepositedBox>& boxes, const Point3& normal);

  /// Calls visit(index, extents of the box) for each box among the first `count` whose extents meet a region,
  /// in the order of deposition, until it returns true.
  /// @param region  an `Extents`, or any type with its `meets`
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
  std::vector<std::size_t> boxes_per_node_;   ///< for each level
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
