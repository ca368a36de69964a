// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// The links of a URDF, parents before children, with joints of any names.
class LinkTree {
 public:
  /// @throws InvalidConfig if a joint is neither fixed, prismatic, revolute nor continuous, or its axis is
  ///   not of unit length
  explicit LinkTree(const urdf::ModelInterface& model);

  /// Poses of all links over the root, by name [mm].
  /// @param joints  values by name [mm, rad]; joints that are missing are at 0
  std::map<std::string, Eigen::Isometry3d> rootFromLinks(const std::map<std::string, double>& joints) const;

 private:
  struct Node {
    std::string name;
    std::size_t parent = 0;
    Eigen::Isometry3d parent_from_link_at_zero = Eigen::Isometry3d::Identity();
    std::string joint;  ///< empty if fixed
    bool is_linear = false;
    Point3 axis = Point3::Zero();
  };
  std::vector<Node> nodes_;
};

}  // namespace lamina
