// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/arap.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <utility>

#include "parameterization/coarse_grid.hpp"

namespace lamina {
namespace {

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

/// The sum's second derivatives with the turns held. Vertex 0 is left out: it stays, which makes the plan
/// unique.
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

void stepTogether(const Solver& solver, const ArapEnergy::Pull& pull, std::vector<Point2>& plan) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> pulls(static_cast<Eigen::Index>(plan.size()) - 1, 2);
  for (Eigen::Index i = 0; i < pulls.rows(); ++i)
    pulls.row(i) = pull.at_vertex[static_cast<std::size_t>(i) + 1];
  const Eigen::Matrix<double, Eigen::Dynamic, 2> step = solver.solve(pulls);
  for (Eigen::Index i = 0; i < step.rows(); ++i) plan[static_cast<std::size_t>(i) + 1] += step.row(i);
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
/// @param step  changes a plan by the pull on it
template <class Step>
std::vector<Point2> descend(const ArapEnergy& energy, std::vector<Point2> plan, int iterations,
                            double converged, const Step& step) {
  ArapEnergy::Pull pull = energy.pullOn(plan);
  for (int i = 0; i < iterations; ++i) {
    std::vector<Point2> next = plan;
    step(pull, next);
    ArapEnergy::Pull next_pull = energy.pullOn(next);
    if (!(next_pull.energy < pull.energy)) break;
    const bool is_last = !(next_pull.energy < (1.0 - converged) * pull.energy);
    plan = std::move(next);
    pull = std::move(next_pull);
    if (is_last) break;
  }
  return plan;
}

}  // namespace

std::vector<Point2> relaxArap(const ArapEnergy& energy, std::vector<Point2> guess) {
  if (guess.size() < 3) return guess;
  const Solver solver(stiffness(energy));
  return descend(
      energy, std::move(guess), kIterations, kConverged,
      [&](const ArapEnergy::Pull& pull, std::vector<Point2>& plan) { stepTogether(solver, pull, plan); });
}

std::vector<Point2> relaxCoarsely(const ArapEnergy& energy, std::vector<Point2> guess) {
  const CoarseGrid grid(energy, guess);
  const std::vector<double> hold = holds(energy);
  const auto stepAlone = [&](const ArapEnergy::Pull& pull, std::vector<Point2>& plan) {
    for (std::size_t i = 0; i < plan.size(); ++i)
      if (hold[i] > 0.0) plan[i] += kDamping / hold[i] * pull.at_vertex[i];
  };
  const auto stepOnGrid = [&](const ArapEnergy::Pull& pull, std::vector<Point2>& plan) {
    grid.step(pull.at_vertex, plan);
  };
  for (int i = 0; i < kRounds; ++i) {
    guess = descend(energy, std::move(guess), kCoarseIterations, kCoarselyConverged, stepOnGrid);
    guess = descend(energy, std::move(guess), kSingleSteps, 0.0, stepAlone);
  }
  return guess;
}

}  // namespace lamina
