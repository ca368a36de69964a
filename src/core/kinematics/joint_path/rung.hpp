// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace lamina {

/// What the samples of a rung vary.
enum class SampleKind : std::uint8_t {
  Single,     ///< nothing: there is one sample, the pose as it is
  Yaw,        ///< the rotation of the nozzle about its tool axis
  FreeJoint,  ///< the value of the joint that is free at a singularity
};

/// Number of a node within its rung, in 2 bytes: sample * kMostBranches + branch.
using NodeId = std::uint16_t;
constexpr int kMostBranches = 128;
constexpr int kUsualBranches = 8;  ///< usual number of branches of an arm
constexpr int kMostSamples = 511;  ///< greatest number of samples of all rows together
constexpr NodeId kNoNode = 0xFFFF;

inline NodeId nodeId(int sample, int branch) { return static_cast<NodeId>(sample * kMostBranches + branch); }
inline int sampleOf(NodeId node) { return node / kMostBranches; }
inline int branchOf(NodeId node) { return node % kMostBranches; }

/// All joint values that reach one station: a node for each sample and branch, some of which do not exist.
struct Rung {
  SampleKind kind = SampleKind::Single;
  int samples = 0;
  /// Number of rows of samples: one row for each value of the redundancy. The values are equally spaced
  /// around a turn. The samples of a row follow each other.
  int rows = 1;
  int branches = 0;
  int joints = 0;
  std::vector<double> values;   ///< joint values, node after node: the branches of a sample follow each other
  std::vector<double> penalty;  ///< cost per second of each node; infinite if the node does not exist

  std::size_t slot(int sample, int branch) const {
    return static_cast<std::size_t>(sample) * static_cast<std::size_t>(branches) +
           static_cast<std::size_t>(branch);
  }
  const double* at(std::size_t node_slot) const {
    return values.data() + node_slot * static_cast<std::size_t>(joints);
  }
  NodeId idOf(std::size_t node_slot) const {
    const auto per_sample = static_cast<std::size_t>(branches);
    return nodeId(static_cast<int>(node_slot / per_sample), static_cast<int>(node_slot % per_sample));
  }
  std::size_t slotOf(NodeId node) const { return slot(sampleOf(node), branchOf(node)); }
};

}  // namespace lamina
