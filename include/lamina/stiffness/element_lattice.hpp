// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Consecutive nodes of a row along x; their numbers are consecutive, too.
struct NodeSpan {
  std::int32_t begin = 0;  ///< index along x of the first node
  std::int32_t count = 0;  ///< number of nodes
  std::int32_t node = 0;   ///< number of the first node in the lattice

  std::int32_t end() const { return begin + count; }
};

/// Consecutive elements of a row along x.
struct ElementRun {
  std::int32_t begin = 0;   ///< index along x of the first element
  std::int32_t count = 0;   ///< number of elements, at most ElementLattice::kLongestRun
  std::int32_t column = 0;  ///< index of the first element in `ElementLattice::density`
  /// Number of the first element's first node in each of the node rows (j, k), (j+1, k), (j, k+1),
  /// (j+1, k+1), for the element row (j, k).
  std::array<std::int32_t, 4> node{};
};

/// Cubic elements at some of the cells of a regular lattice, and the nodes at their corners. Rows run along
/// x; nodes are numbered row by row. Memory is used for the elements and nodes that exist only.
class ElementLattice {
 public:
  static constexpr std::int32_t kLongestRun = 63;

  /// An empty lattice.
  ElementLattice() = default;

  /// A lattice over a range of voxels, with an element for each solid one.
  /// @throws InvalidInput if there are more than 2^31 nodes
  ElementLattice(const VoxelGrid& grid, const VoxelRange& range);

  /// A lattice of elements twice as large, one wherever `fine` has at least one; their density is the mean of
  /// the eight cells.
  static ElementLattice coarsened(const ElementLattice& fine);

  /// This lattice without some of its runs.
  /// @param is_kept  for each run, in their order, whether its elements remain
  ElementLattice withRuns(const std::vector<bool>& is_kept) const;

  /// Number of cells along x, y, z, with or without element.
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

  /// Solid share of each element, (0, 1], run by run, with a 0 after each run.
  const std::vector<float>& density() const { return density_; }

  /// Number of the node at a corner of the lattice; -1 if there is none.
  std::int32_t nodeAt(int i, int j, int k) const;

 private:
  explicit ElementLattice(const std::array<int, 3>& count);
  void addRow(const std::vector<float>& densities);
  void numberNodes();

  std::array<int, 3> count_{};  ///< number of cells along x, y, z
  std::int32_t nodes_ = 0;
  std::int64_t elements_ = 0;
  std::vector<std::int32_t> element_row_{0};
  std::vector<ElementRun> element_runs_;
  std::vector<std::int32_t> node_row_{0};
  std::vector<NodeSpan> node_runs_;
  std::vector<float> density_;
};

}  // namespace lamina
