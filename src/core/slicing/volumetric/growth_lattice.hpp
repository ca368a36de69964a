// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "slicing/volumetric/arrival_field.hpp"
#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// Growth at the middle of a cell, for one piece of the part.
struct GrowthSample {
  double growth_mm = 0.0;
  Point3 gradient = Point3::UnitZ();  ///< as of `GrowthAt`
  double steepness = 1.0;             ///< its length; between samples their mean, where fronts meet too
  Point3 at = Point3::Zero();
  std::uint32_t node = CellGraph::kNone;  ///< of the part; none for one beside it
};

/// Eight neighbouring cells and one piece of the part in them: a sample a corner. Corner x + 2 y + 4 z is
/// that at x, y, z.
struct GrowthCube {
  std::array<int, 3> cell{};  ///< of corner 0
  std::array<std::uint32_t, 8> sample{};
};

/// A growth field on the middles of cells, carried one cell out of the part, so that surfaces of equal growth
/// reach its skin. Cells have a sample for each piece of the part in or beside them; cubes of samples join
/// what is linked, and nothing across gaps.
class GrowthLattice {
 public:
  GrowthLattice(const CellGraph& cells, const ArrivalField& field, const GrowthGauge& gauge,
                Progress& progress);

  const std::vector<GrowthSample>& samples() const { return samples_; }
  /// By their cells, along x first.
  const std::vector<GrowthCube>& cubes() const { return cubes_; }
  /// First of the cubes whose corner 0 is a cell, and one past the last. None beyond the frame.
  std::array<std::uint32_t, 2> cubesAt(const std::array<int, 3>& cell) const;

  /// Growth at a point within a cube, linear between its corners along each axis; its gradient likewise.
  GrowthSample within(const GrowthCube& cube, const Point3& point) const;

 private:
  struct Beside {
    std::uint32_t cell = 0;
    std::vector<std::uint32_t> of;  // the nodes whose piece it carries on, ascending
  };

  void addNodes(const ArrivalField& field, const GrowthGauge& gauge);
  void addBeside(const ArrivalField& field, const GrowthGauge& gauge, Progress& progress);
  std::vector<Beside> besideCell(const std::array<int, 3>& cell, const ArrivalField& field) const;
  GrowthSample carriedOn(const Beside& beside, const ArrivalField& field, const GrowthGauge& gauge) const;
  void addCubes(const ArrivalField& field, Progress& progress);
  void appendCubes(const std::array<int, 3>& cell, const ArrivalField& field,
                   std::vector<GrowthCube>& cubes) const;
  std::uint32_t cornerFor(const std::vector<std::uint32_t>& piece, const std::array<int, 3>& cell,
                          const ArrivalField& field) const;
  std::size_t numberOf(const std::array<int, 3>& cell) const;

  const CellGraph& cells_;
  std::vector<GrowthSample> samples_;     // of nodes by their numbers, then of places beside the part
  std::vector<Beside> beside_;            // by cells
  std::vector<std::uint32_t> beside_at_;  // of each cell its first, and the count at the end
  std::vector<GrowthCube> cubes_;
  std::vector<std::uint32_t> cubes_at_;
};

}  // namespace lamina
