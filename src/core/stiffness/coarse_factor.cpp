// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/coarse_factor.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/stiffness/element_stiffness.hpp"

namespace lamina {
namespace {

// Part of the diagonal added to it: what floats as a whole on the coarsest lattice still has a factor.
constexpr double kHold = 1e-7;

using Entries = std::vector<Eigen::Triplet<double>>;

void addElement(const ElementMatrix& stiffness, double density, const std::array<std::int32_t, 8>& node,
                const std::vector<bool>& is_given, Entries& entries) {
  for (int row = 0; row < 24; ++row) {
    const std::int32_t to = 3 * node[std::size_t(row / 3)] + row % 3;
    if (is_given[std::size_t(to)]) continue;
    for (int column = 0; column < 24; ++column) {
      const std::int32_t from = 3 * node[std::size_t(column / 3)] + column % 3;
      if (from > to || is_given[std::size_t(from)]) continue;
      const double hold = row == column ? 1.0 + kHold : 1.0;
      entries.emplace_back(to, from, hold * density * stiffness(row, column));
    }
  }
}

}  // namespace

struct CoarseFactor::Factor {
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky;
  std::vector<bool> is_given;
};

CoarseFactor::~CoarseFactor() = default;
CoarseFactor::CoarseFactor(CoarseFactor&&) noexcept = default;
CoarseFactor& CoarseFactor::operator=(CoarseFactor&&) noexcept = default;

CoarseFactor::CoarseFactor(const ElasticElements& elements, const GivenNodes& given)
    : factor_(std::make_unique<Factor>()) {
  const ElementLattice& lattice = elements.lattice;
  const std::size_t unknowns = 3 * std::size_t(lattice.nodeCount());
  factor_->is_given.resize(unknowns);
  Entries entries;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::int32_t node : given[axis]) {
      factor_->is_given[3 * std::size_t(node) + axis] = true;
      entries.emplace_back(3 * node + int(axis), 3 * node + int(axis), 1.0);
    }
  const ElementMatrix stiffness = elementStiffness(elements.material, elements.element_mm);
  for (int row = 0; row < lattice.count()[1] * lattice.count()[2]; ++row)
    for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run)
      for (std::int32_t i = 0; i < run->count; ++i) {
        std::array<std::int32_t, 8> node{};
        for (std::size_t c = 0; c < 8; ++c) node[c] = run->node[c / 2] + i + std::int32_t(c % 2);
        addElement(stiffness, double(lattice.density().data()[run->column + i]), node, factor_->is_given,
                   entries);
      }
  Eigen::SparseMatrix<double> matrix{Eigen::Index(unknowns), Eigen::Index(unknowns)};
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_->cholesky.compute(matrix);
  if (factor_->cholesky.info() != Eigen::Success)
    throw InvalidInput("stiffness of the coarsest lattice has no factors; what bears the load must be held");
}

void CoarseFactor::solve(const NodeField<float>& force, NodeField<float>& displacement) const {
  Eigen::VectorXd right(Eigen::Index(3 * force.size()));
  for (std::size_t node = 0; node < force.size(); ++node)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = 3 * node + axis;
      right[Eigen::Index(at)] = factor_->is_given[at] ? 0.0 : double(force.along[axis][node]);
    }
  const Eigen::VectorXd solved = factor_->cholesky.solve(right);
  for (std::size_t node = 0; node < force.size(); ++node)
    for (std::size_t axis = 0; axis < 3; ++axis)
      displacement.along[axis][node] = float(solved[Eigen::Index(3 * node + axis)]);
}

}  // namespace lamina
