// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/deposited_tree.hpp"

#include <utility>

namespace lamina {
namespace {

Extents extentsOf(const DepositedBox& box, const Point3& normal) {
  const Eigen::Matrix3d axes = box.rotation.cast<double>().normalized().toRotationMatrix();
  const Point3 half = 0.5 * box.size.cast<double>();
  const Point3 reach = axes.cwiseAbs() * half;
  const double along = (axes.transpose() * normal).cwiseAbs().dot(half);
  const double middle = normal.dot(box.middle);
  Extents extents;
  extents.box = {box.middle - reach, box.middle + reach};
  extents.low_normal = middle - along;
  extents.high_normal = middle + along;
  return extents;
}

}  // namespace

DepositedTree::DepositedTree(const std::vector<DepositedBox>& boxes, const Point3& normal) {
  std::vector<Extents> level;
  level.reserve(boxes.size());
  for (const DepositedBox& box : boxes) level.push_back(extentsOf(box, normal));
  std::size_t per_node = 1;
  while (level.size() > 1) {
    std::vector<Extents> above((level.size() + kChildren - 1) / kChildren);
    for (std::size_t i = 0; i < level.size(); ++i) above[i / kChildren].include(level[i]);
    levels_.push_back(std::exchange(level, std::move(above)));
    boxes_per_node_.push_back(std::exchange(per_node, per_node * kChildren));
  }
  levels_.push_back(std::move(level));
  boxes_per_node_.push_back(per_node);
}

}  // namespace lamina
