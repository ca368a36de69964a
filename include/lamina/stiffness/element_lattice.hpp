// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Nodes of a row along x that follow each other, numbered one after the other.
struct NodeSpan {
  std::int32_t begin = 0;  ///< first node, counted along x
  std::int32_t count = 0;
  std::int32_t node = 0;  ///< number of the first one

  std::int32_t end() const { return begin + count; }
};

/// Elements of a row along x that follow each other.
struct ElementRun {
  std::int32_t begin = 0;              ///< first element, counted along x
  std::int32_t count = 0;              ///< at most ElementLattice::kLongestRun
  std::int32_t column = 0;             ///< of the first element in `density`
  std::array<std::int32_t, 4> node{};  ///< number of the first node in the rows (j, k), (j+1, k), (j, k+1),
                                       ///< (j+1, k+1)
};

/// Cubic elements on part of a lattice, and the nodes at their corners, numbered row by row. Only what is
/// there is held.
class ElementLattice {
 public:
  static constexpr std::int32_t kLongestRun = 63;

  /// Nothing.
  ElementLattice() = default;

  /// One element for each solid voxel of a range.
  /// @throws InvalidInput if there are more nodes than 2^31
  ElementLattice(const VoxelGrid& grid, const VoxelRange& range);

  /// Elements twice as large, wherever there is one of `fine`; their density is the mean of the eight places.
  static ElementLattice coarsened(const ElementLattice& fine);

  /// The same places with the elements of some runs only, in the order of the runs.
  ElementLattice withRuns(const std::vector<bool>& is_kept) const;

  /// Elements along x, y, z, whether they are there or not.
  const std::array<int, 3>& count() const { return count_; }
  std::int32_t nodeCount() const { return nodes_; }
  std::int64_t elementCount() const { return elements_; }
  std::size_t bytes() const;

  std::size_t runCount() const { return element_runs_.size(); }

  int elementRow(int j, int k) const { return k * count_[1] + j; }
  int nodeRow(int j, int k) const { return k * (count_[1] + 1) + j; }
  int nodeRowCount() const { return (count_[1] + 1) * (count_[2] + 1); }

  const ElementRun* elementsBegin(int row) const { return element_runs_.data() + element_row_[size_t(row)]; }
  const ElementRun* elementsEnd(int row) const { return elementsBegin(row + 1); }
  const NodeSpan* nodesBegin(int row) const { return node_runs_.data() + node_row_[size_t(row)]; }
  const NodeSpan* nodesEnd(int row) const { return nodesBegin(row + 1); }

  /// Part of each element that is solid, (0, 1], in the order of the runs; after each run stands a 0.
  const std::vector<float>& density() const { return density_; }

  /// Number of the node, -1 where there is none.
  std::int32_t nodeAt(int i, int j, int k) const;

 private:
  explicit ElementLattice(const std::array<int, 3>& count);
  void addRow(const std::vector<float>& densities);
  void numberNodes();

  std::array<int, 3> count_{};  ///< elements along x, y, z
  std::int32_t nodes_ = 0;
  std::int64_t elements_ = 0;
  std::vector<std::int32_t> element_row_{0};
  std::vector<ElementRun> element_runs_;
  std::vector<std::int32_t> node_row_{0};
  std::vector<NodeSpan> node_runs_;
  std::vector<float> density_;
};

}  // namespace lamina
