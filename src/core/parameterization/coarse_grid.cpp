// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/coarse_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

constexpr double kVerticesPerCell = 20.0;
constexpr double kMostCells = 1e5;
// Holds nodes that no triangle is near to, as a share of what a full cell does.
constexpr double kLoose = 1e-4;

double areaInPlan(const Triangle& corner, const std::vector<Point2>& plan) {
  const Point2 ab = plan[corner[1]] - plan[corner[0]];
  const Point2 ac = plan[corner[2]] - plan[corner[0]];
  return 0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x());
}

/// What a triangle resists an even growth of its place in the plan with, by directions.
Eigen::Matrix2d resistanceOf(const ArapEnergy::FlatTriangle& triangle, const Triangle& corner,
                             const std::vector<Point2>& plan) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 side = plan[corner[(i + 1) % 3]] - plan[corner[i]];
    sum += triangle.weight[i] * side * side.transpose();
  }
  return sum;
}

double cellSize(const Mesh& surface, const std::vector<Point2>& plan, const Point2& box) {
  double area = 0.0;
  for (const Triangle& corner : surface.triangles) area += areaInPlan(corner, plan);
  const double wanted = area * kVerticesPerCell / static_cast<double>(plan.size());
  const double least =
      std::max(box.x() * box.y() / kMostCells, box.squaredNorm() / (kMostCells * kMostCells));
  return std::sqrt(std::max({wanted, least, std::numeric_limits<double>::min()}));
}

}  // namespace

CoarseGrid::CoarseGrid(const ArapEnergy& energy, const std::vector<Point2>& plan) {
  Box2 box;
  for (const Point2& place : plan) box.include(place);
  const double cell = cellSize(energy.surface(), plan, box.size());
  columns_ = static_cast<std::uint32_t>(std::floor(box.size().x() / cell)) + 2;
  rows_ = static_cast<std::uint32_t>(std::floor(box.size().y() / cell)) + 2;
  places_.reserve(plan.size());
  for (const Point2& place : plan) {
    const Point2 at = (place - box.low) / cell;
    const auto column = static_cast<std::uint32_t>(at.x());
    const auto row = static_cast<std::uint32_t>(at.y());
    places_.push_back({row * columns_ + column, at.x() - column, at.y() - row});
  }
  std::vector<Eigen::Matrix2d> resistance(std::size_t{columns_} * rows_, Eigen::Matrix2d::Zero());
  for (std::size_t t = 0; t < energy.triangles().size(); ++t) {
    const Triangle& corner = energy.surface().triangles[t];
    const Eigen::Matrix2d share = resistanceOf(energy.triangles()[t], corner, plan) / (3.0 * cell * cell);
    for (const std::uint32_t vertex : corner) resistance[places_[vertex].node] += share;
  }
  factorise(resistance);
}

/// A membrane, bilinear in each cell, that resists in each cell as its triangles do.
void CoarseGrid::factorise(const std::vector<Eigen::Matrix2d>& resistance) {
  // Integrals over a cell of the products of the slopes of what is 1 at one corner and 0 at the others.
  Eigen::Matrix4d along_x, along_y, across;
  along_x << 2, -2, -1, 1, -2, 2, 1, -1, -1, 1, 2, -2, 1, -1, -2, 2;
  along_y << 2, 1, -1, -2, 1, 2, -2, -1, -1, -2, 2, 1, -2, -1, 1, 2;
  across << 1, 0, -1, 0, 0, -1, 0, 1, -1, 0, 1, 0, 0, 1, 0, -1;
  const std::array<std::uint32_t, 4> corner = {0, 1, columns_ + 1, columns_};
  std::vector<Eigen::Triplet<double>> entries;
  const auto nodes = static_cast<int>(resistance.size());
  entries.reserve(11 * resistance.size());
  for (int node = 0; node < nodes; ++node) entries.emplace_back(node, node, kLoose);
  for (std::uint32_t node = 0; node < resistance.size(); ++node) {
    const Eigen::Matrix2d& cell = resistance[node];
    if (cell.isZero(0.0)) continue;
    const Eigen::Matrix4d stiffness =
        (cell(0, 0) * along_x + cell(1, 1) * along_y) / 6.0 + 0.5 * cell(0, 1) * across;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const auto row = static_cast<int>(node + corner[static_cast<std::size_t>(i)]);
        const auto column = static_cast<int>(node + corner[static_cast<std::size_t>(j)]);
        if (row >= column) entries.emplace_back(row, column, stiffness(i, j));
      }
  }
  Eigen::SparseMatrix<double> matrix(nodes, nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  solver_.compute(matrix);
}

void CoarseGrid::step(const std::vector<Point2>& pull, std::vector<Point2>& plan) const {
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> at_node(Eigen::Index{columns_} * rows_, 2);
  at_node.setZero();
  const auto forNodes = [this](std::size_t vertex, const auto& visit) {
    const Place& place = places_[vertex];
    visit(place.node, (1.0 - place.x) * (1.0 - place.y));
    visit(place.node + 1, place.x * (1.0 - place.y));
    visit(place.node + columns_, (1.0 - place.x) * place.y);
    visit(place.node + columns_ + 1, place.x * place.y);
  };
  for (std::size_t i = 0; i < pull.size(); ++i)
    forNodes(i, [&](std::uint32_t node, double share) { at_node.row(node) += share * pull[i]; });
  const Eigen::Matrix<double, Eigen::Dynamic, 2> step = solver_.solve(at_node);
  for (std::size_t i = 0; i < plan.size(); ++i)
    forNodes(i, [&](std::uint32_t node, double share) { plan[i] += share * step.row(node); });
}

}  // namespace lamina
