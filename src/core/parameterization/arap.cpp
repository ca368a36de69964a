// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/arap.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "arap.hpp"
#include "arap_energy.hpp"

namespace lamina {
namespace {

/// A square grid over a parameterization, to find smooth changes of the parameterization: those that are
/// bilinear in each cell. Cells hold some twenty vertices.
class CoarseGrid {
 public:
  CoarseGrid(const ArapEnergy& energy, const std::vector<Point2>& parameterization);

  /// Changes a parameterization such that the pull on it vanishes on average over the cells, as far as the
  /// surface resists like an even membrane.
  void step(const std::vector<Point2>& pull, std::vector<Point2>& parameterization) const;

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

constexpr double kVerticesPerCell = 20.0;
constexpr double kMostCells = 1e5;
// Holds nodes that no triangle is near to, as a share of what a full cell does.
constexpr double kLoose = 1e-4;

double areaInParameters(const Triangle& corner, const std::vector<Point2>& parameterization) {
  const Point2 ab = parameterization[corner[1]] - parameterization[corner[0]];
  const Point2 ac = parameterization[corner[2]] - parameterization[corner[0]];
  return 0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x());
}

/// What a triangle resists an even growth of its place in the parameter plane with, by directions.
Eigen::Matrix2d resistanceOf(const ArapEnergy::FlatTriangle& triangle, const Triangle& corner,
                             const std::vector<Point2>& parameterization) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 side = parameterization[corner[(i + 1) % 3]] - parameterization[corner[i]];
    sum += triangle.weight[i] * side * side.transpose();
  }
  return sum;
}

double cellSize(const Mesh& surface, const std::vector<Point2>& parameterization, const Point2& box) {
  double area = 0.0;
  for (const Triangle& corner : surface.triangles) area += areaInParameters(corner, parameterization);
  const double wanted = area * kVerticesPerCell / static_cast<double>(parameterization.size());
  const double least =
      std::max(box.x() * box.y() / kMostCells, box.squaredNorm() / (kMostCells * kMostCells));
  return std::sqrt(std::max({wanted, least, std::numeric_limits<double>::min()}));
}

CoarseGrid::CoarseGrid(const ArapEnergy& energy, const std::vector<Point2>& parameterization) {
  Box2 box;
  for (const Point2& place : parameterization) box.include(place);
  const double cell = cellSize(energy.surface(), parameterization, box.size());
  columns_ = static_cast<std::uint32_t>(std::floor(box.size().x() / cell)) + 2;
  rows_ = static_cast<std::uint32_t>(std::floor(box.size().y() / cell)) + 2;
  places_.reserve(parameterization.size());
  for (const Point2& place : parameterization) {
    const Point2 at = (place - box.low) / cell;
    const auto column = static_cast<std::uint32_t>(at.x());
    const auto row = static_cast<std::uint32_t>(at.y());
    places_.push_back({row * columns_ + column, at.x() - column, at.y() - row});
  }
  std::vector<Eigen::Matrix2d> resistance(std::size_t{columns_} * rows_, Eigen::Matrix2d::Zero());
  for (std::size_t t = 0; t < energy.triangles().size(); ++t) {
    const Triangle& corner = energy.surface().triangles[t];
    const Eigen::Matrix2d share =
        resistanceOf(energy.triangles()[t], corner, parameterization) / (3.0 * cell * cell);
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

void CoarseGrid::step(const std::vector<Point2>& pull, std::vector<Point2>& parameterization) const {
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
  for (std::size_t i = 0; i < parameterization.size(); ++i)
    forNodes(i, [&](std::uint32_t node, double share) { parameterization[i] += share * step.row(node); });
}

constexpr int kIterations = 30;
// Iterations end when one lessens the sum by less than this share of it.
constexpr double kConverged = 1e-3;
constexpr double kCoarselyConverged = 0.02;
constexpr int kRounds = 2;
constexpr int kCoarseIterations = 10;
constexpr int kSingleSteps = 4;
// Of the steps of single vertices, so that neighbours that step at once do not overshoot.
constexpr double kDamping = 0.6;

using Solver = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>;

/// The sum's second derivatives with the turns held. Vertex 0 is left out: it stays, which makes the
/// parameterization unique.
Eigen::SparseMatrix<double> stiffness(const ArapEnergy& energy) {
  const Mesh& surface = energy.surface();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * surface.triangles.size());
  const auto add = [&entries](std::uint32_t row, std::uint32_t column, double value) {
    if (column > 0) entries.emplace_back(static_cast<int>(row) - 1, static_cast<int>(column) - 1, value);
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = surface.triangles[t][i];
      const std::uint32_t to = surface.triangles[t][(i + 1) % 3];
      const double weight = energy.triangles()[t].weight[i];
      add(from, from, weight);
      add(to, to, weight);
      add(std::max(from, to), std::min(from, to), -weight);
    }
  const auto size = static_cast<Eigen::Index>(surface.vertices.size()) - 1;
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void stepTogether(const Solver& solver, const ArapEnergy::Pull& pull, std::vector<Point2>& parameterization) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> pulls(static_cast<Eigen::Index>(parameterization.size()) - 1, 2);
  for (Eigen::Index i = 0; i < pulls.rows(); ++i)
    pulls.row(i) = pull.at_vertex[static_cast<std::size_t>(i) + 1];
  const Eigen::Matrix<double, Eigen::Dynamic, 2> step = solver.solve(pulls);
  for (Eigen::Index i = 0; i < step.rows(); ++i)
    parameterization[static_cast<std::size_t>(i) + 1] += step.row(i);
}

/// How strongly each vertex is held where its neighbours want it.
std::vector<double> holds(const ArapEnergy& energy) {
  std::vector<double> hold(energy.surface().vertices.size(), 0.0);
  for (std::size_t t = 0; t < energy.triangles().size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      hold[energy.surface().triangles[t][i]] += energy.triangles()[t].weight[i];
      hold[energy.surface().triangles[t][(i + 1) % 3]] += energy.triangles()[t].weight[i];
    }
  return hold;
}

/// Steps while they lessen the sum noticeably.
/// @param step  changes a parameterization by the pull on it
template <class Step>
std::vector<Point2> descend(const ArapEnergy& energy, std::vector<Point2> parameterization, int iterations,
                            double converged, const Step& step) {
  ArapEnergy::Pull pull = energy.pullOn(parameterization);
  for (int i = 0; i < iterations; ++i) {
    std::vector<Point2> next = parameterization;
    step(pull, next);
    ArapEnergy::Pull next_pull = energy.pullOn(next);
    if (!(next_pull.energy < pull.energy)) break;
    const bool is_last = !(next_pull.energy < (1.0 - converged) * pull.energy);
    parameterization = std::move(next);
    pull = std::move(next_pull);
    if (is_last) break;
  }
  return parameterization;
}

}  // namespace

std::vector<Point2> relaxArap(const ArapEnergy& energy, std::vector<Point2> guess) {
  if (guess.size() < 3) return guess;
  const Solver solver(stiffness(energy));
  return descend(energy, std::move(guess), kIterations, kConverged,
                 [&](const ArapEnergy::Pull& pull, std::vector<Point2>& parameterization) {
                   stepTogether(solver, pull, parameterization);
                 });
}

std::vector<Point2> relaxCoarsely(const ArapEnergy& energy, std::vector<Point2> guess) {
  const CoarseGrid grid(energy, guess);
  const std::vector<double> hold = holds(energy);
  const auto stepAlone = [&](const ArapEnergy::Pull& pull, std::vector<Point2>& parameterization) {
    for (std::size_t i = 0; i < parameterization.size(); ++i)
      if (hold[i] > 0.0) parameterization[i] += kDamping / hold[i] * pull.at_vertex[i];
  };
  const auto stepOnGrid = [&](const ArapEnergy::Pull& pull, std::vector<Point2>& parameterization) {
    grid.step(pull.at_vertex, parameterization);
  };
  for (int i = 0; i < kRounds; ++i) {
    guess = descend(energy, std::move(guess), kCoarseIterations, kCoarselyConverged, stepOnGrid);
    guess = descend(energy, std::move(guess), kSingleSteps, 0.0, stepAlone);
  }
  return guess;
}

}  // namespace lamina
