// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <cstdint>
#include <vector>

#include "parameterization/arap_energy.hpp"

namespace lamina {

/// A square grid over a plan, to find smooth changes of the plan: those that are bilinear in each cell. Cells
/// hold some twenty vertices.
class CoarseGrid {
 public:
  CoarseGrid(const ArapEnergy& energy, const std::vector<Point2>& plan);

  /// Changes a plan such that the pull on it vanishes on average over the cells, as far as the surface
  /// resists like an even membrane.
  void step(const std::vector<Point2>& pull, std::vector<Point2>& plan) const;

 private:
  void factorise(const std::vector<Eigen::Matrix2d>& resistance);

  /// A vertex in its cell.
  struct Place {
    std::uint32_t node = 0;  // at the cell's low corner
    double x = 0.0;          // share of the cell from there
    double y = 0.0;
  };

  std::uint32_t columns_ = 0;  // of nodes
  std::uint32_t rows_ = 0;
  std::vector<Place> places_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace lamina
