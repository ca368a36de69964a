// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace lamina {

BoxTree::BoxTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)), items_(boxes_.size()) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kLeaf = 4;
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node& node = nodes_.emplace_back();
  for (std::uint32_t i = first; i < last; ++i) {
    node.box.include(boxes_[items_[i]].low);
    node.box.include(boxes_[items_[i]].high);
  }
  if (last - first <= kLeaf) {
    node.first = first;
    node.count = last - first;
    return number;
  }
  Eigen::Index axis = 0;
  node.box.size().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  const auto centre = [&](std::uint32_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return centre(a) != centre(b) ? centre(a) < centre(b) : a < b;
                   });
  build(first, middle);
  const std::uint32_t right = build(middle, last);
  nodes_[number].first = right;
  return number;
}

}  // namespace lamina
