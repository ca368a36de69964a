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

/// Growth at the middle of a cell, for one connected piece of the part in it.
struct GrowthSample {
  double growth_mm = 0.0;
  Point3 gradient = Point3::UnitZ();  ///< as in `GrowthAt`
  /// Length of the gradient; between samples the mean of their lengths, also where fronts meet.
  double steepness = 1.0;
  Point3 at = Point3::Zero();
  std::uint32_t node = CellGraph::kNone;  ///< node of the part; `kNone` if the sample lies beside the part
};

/// Eight neighbouring cells with one connected piece of the part in them: a sample for each corner, the one
/// at x, y, z with index x + 2 y + 4 z.
struct GrowthCube {
  std::array<int, 3> cell{};  ///< the cell of corner 0
  std::array<std::uint32_t, 8> sample{};
};

/// Samples of a growth field at the middles of cells, extrapolated by one cell beyond the part so that
/// surfaces of equal growth reach its skin. A cell has a sample for each piece of the part in it or beside
/// it. Cubes join samples of linked nodes only, never across a gap.
class GrowthLattice {
 public:
  GrowthLattice(const CellGraph& cells, const ArrivalField& field, const GrowthGauge& gauge,
                Progress& progress);

  const std::vector<GrowthSample>& samples() const { return samples_; }
  /// All cubes, sorted by cell, along x first.
  const std::vector<GrowthCube>& cubes() const { return cubes_; }
  /// Range of the cubes whose corner 0 is this cell: the first, and one past the last. Empty beyond the
  /// frame.
  std::array<std::uint32_t, 2> cubesAt(const std::array<int, 3>& cell) const;

  /// Growth and gradient at a point in a cube, interpolated trilinearly between its corners.
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
