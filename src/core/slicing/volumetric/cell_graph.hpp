// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// A contiguous range of numbers in a vector.
struct NumberRange {
  const std::uint32_t* first = nullptr;
  const std::uint32_t* last = nullptr;
  const std::uint32_t* begin() const { return first; }
  const std::uint32_t* end() const { return last; }
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
};

/// A place in a node of a `CellGraph`, or on the surface of its bits.
struct NodePlace {
  std::uint32_t node = 0;
  Point3 at = Point3::Zero();
};

/// A part in cubic cells of 4 x 4 x 4 bits, each bit solid if its middle is inside the part. A node is a set
/// of bits of one cell that are connected by their faces; most cells have one node. Nodes of neighbouring
/// cells (26 neighbours) are linked if their bits touch, or if touching nodes in cells of a common block of 2
/// x 2 x 2 join them. Nodes on both sides of a gap narrower than a cell are not linked.
///
/// Nodes are numbered by cell, along x first. The frame has a margin of one empty cell around the part.
class CellGraph {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  static constexpr std::uint64_t kFull = 0xFFFFFFFFFFFFFFFF;
  static constexpr int kBits = 4;  ///< along a side of a cell

  /// @param mesh      closed [mm]
  /// @param floor_mm  z below which the part is left out
  /// @throws InvalidMesh, InvalidInput as `voxelisedMesh`; Cancelled
  CellGraph(const Mesh& mesh, double cell_mm, double floor_mm, Progress& progress);

  const VoxelFrame& frame() const { return frame_; }
  double bitSide() const { return frame_.voxel_mm / kBits; }
  std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(bits_.size()); }

  /// Solid bits of the node's cell that belong to it: bit x + 4 y + 16 z lies at x, y, z in the cell.
  std::uint64_t bits(std::uint32_t node) const { return bits_[node]; }
  std::array<int, 3> cell(std::uint32_t node) const { return placeOf(cell_[node]); }
  /// Corner of the node's cell at the lower end of all axes.
  Point3 corner(std::uint32_t node) const;
  /// Centroid of the node's bits.
  const Point3& middle(std::uint32_t node) const { return middle_[node]; }
  /// Volume of the node's bits [mm³].
  double volume(std::uint32_t node) const;

  /// Nodes of a cell as a range: the first, and one past the last. Empty beyond the frame.
  std::array<std::uint32_t, 2> nodesIn(const std::array<int, 3>& cell) const;
  NumberRange links(std::uint32_t node) const {
    return {links_.data() + link_start_[node], links_.data() + link_start_[node + 1]};
  }
  bool areLinked(std::uint32_t a, std::uint32_t b) const;

  /// The node that contains the bit (i, j, k), counted through all cells; `kNone` if that bit is not solid.
  std::uint32_t nodeOfBit(int i, int j, int k) const;
  std::uint32_t nodeAt(const Point3& point) const;
  /// Whether the straight line from a place in a node to a point stays in the part, to within half a bit.
  bool isClear(const NodePlace& from, const Point3& to) const;

 private:
  std::array<int, 3> placeOf(std::uint32_t cell) const;
  void addNodes(const VoxelGrid& grid, int lowest_row, Progress& progress);
  void link(Progress& progress);
  void appendLinks(std::uint32_t node, std::vector<std::uint32_t>& links) const;
  bool isJoined(std::uint32_t a, std::uint32_t b, std::array<int, 3> offset) const;
  std::uint32_t stepTo(std::uint32_t from, const Point3& point) const;

  VoxelFrame frame_;
  std::vector<std::uint32_t> first_;  // node of each cell, and the count at the end
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> cell_;
  std::vector<Point3> middle_;
  std::vector<std::uint32_t> link_start_;
  std::vector<std::uint32_t> links_;
};

}  // namespace lamina
