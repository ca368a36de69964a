// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/harmonic_heights.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// The cotangent weights of the Laplacian: of an edge, half the sum of those of the angles opposite to it.
template <class Add>
void addTriangle(const RegionTriangulation& region, const Triangle& corners, const Add& add) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t i = corners[(k + 1) % 3];
    const std::uint32_t j = corners[(k + 2) % 3];
    const Point2 u = region.points[i] - region.points[corners[k]];
    const Point2 v = region.points[j] - region.points[corners[k]];
    add(i, j, 0.5 * u.dot(v) / (u.x() * v.y() - u.y() * v.x()));
  }
}

}  // namespace

std::vector<double> harmonicHeights(const RegionTriangulation& region, const std::vector<double>& border) {
  const auto fixed = static_cast<std::uint32_t>(border.size());
  const auto free = static_cast<Eigen::Index>(region.points.size() - border.size());
  std::vector<double> heights = border;
  heights.resize(region.points.size(), 0.0);
  if (free == 0) return heights;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(free);
  const auto addTo = [&](std::uint32_t row, std::uint32_t column, double weight) {
    if (row < fixed) return;
    const auto r = static_cast<Eigen::Index>(row - fixed);
    entries.emplace_back(r, r, weight);
    if (column < fixed)
      right[r] += weight * border[column];
    else
      entries.emplace_back(r, static_cast<Eigen::Index>(column - fixed), -weight);
  };
  for (const Triangle& triangle : region.triangles)
    addTriangle(region, triangle, [&](std::uint32_t i, std::uint32_t j, double weight) {
      addTo(i, j, weight);
      addTo(j, i, weight);
    });
  Matrix matrix(free, free);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Matrix> factorised(matrix);
  const Eigen::VectorXd inside = factorised.solve(right);
  if (factorised.info() != Eigen::Success || !inside.allFinite())
    throw InvalidInput(
        "the heights at " + std::to_string(free) +
        " points inside of a layer cannot be solved; expected triangles that all have an area");
  for (Eigen::Index r = 0; r < free; ++r) heights[fixed + static_cast<std::size_t>(r)] = inside[r];
  return heights;
}

}  // namespace lamina
