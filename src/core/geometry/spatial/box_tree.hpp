// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/boxes.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A balanced tree of boxes. The boxes that overlap a given one are found in logarithmic time.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box3> boxes);

  const Box3& box(std::uint32_t i) const { return boxes_[i]; }

  /// Calls visit(i) for every box that overlaps or touches `box`, in an order that depends on the tree only.
  template <class Visit>
  void visitOverlapping(const Box3& box, Visit visit) const;

 private:
  struct Node {
    Box3 box;
    std::uint32_t first = 0;  // index of its first item if it is a leaf, otherwise number of its right child
    std::uint32_t count = 0;  // 0 for an inner node, whose left child follows it
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last);

  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;
};

template <class Visit>
void BoxTree::visitOverlapping(const Box3& box, Visit visit) const {
  if (nodes_.empty()) return;
  // Halving at every level, the tree of 2^32 boxes is 32 levels deep.
  std::uint32_t waiting[64];
  int depth = 0;
  waiting[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t number = waiting[--depth];
    const Node& node = nodes_[number];
    if (!areOverlapping(node.box, box)) continue;
    if (node.count == 0) {
      waiting[depth++] = node.first;
      waiting[depth++] = number + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (areOverlapping(boxes_[items_[i]], box)) visit(items_[i]);
  }
}

}  // namespace lamina
