// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {

/// Two groups of links that two rotary joints move against each other.
struct JointedPair {
  const RigidGroup* near = nullptr;
  const RigidGroup* far = nullptr;
  std::array<Eigen::Index, 2> joints{};     ///< of the kinematic model; the first next to `near`
  std::array<std::string, 2> axis_links{};  ///< whose origins lie on the axes of the joints
};

/// Every link over the root of the tree [mm], at values of the two joints of a pair [rad].
using PairPoses = std::function<std::map<std::string, Eigen::Isometry3d>(double first, double second)>;

/// At which values of two rotary joints two groups of links are in each other.
class CollisionTable {
 public:
  CollisionTable(const JointedPair& pair, const std::vector<DrivenJoint>& joints, const PairPoses& poses);

  /// Whether the groups may be in each other there. Never false where they are.
  bool isBanned(const JointValues& values) const {
    return cells_[columns_.cellOf(values) * rows_.count + rows_.cellOf(values)];
  }
  const std::string& text() const { return text_; }

 private:
  /// The cells of one joint: of its limits, or of a whole turn if they are further apart.
  struct Cells {
    Eigen::Index joint = 0;
    double low = 0.0;    // [rad]
    double width = 0.0;  // of a cell [rad]
    std::size_t count = 0;

    std::size_t cellOf(const JointValues& values) const;
  };
  struct Filling;

  static Cells cellsOf(Eigen::Index index, const DrivenJoint& joint);

  Cells columns_;
  Cells rows_;
  std::vector<bool> cells_;
  std::string text_;
};

}  // namespace lamina
