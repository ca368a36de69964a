// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/random.hpp"
#include "stiffness/lattice_transfer.hpp"
#include "stiffness/matrix_free_operator.hpp"
#include "stiffness/node_blocks.hpp"

namespace lamina {
namespace {

constexpr std::int32_t kCoarsestNodes = 1500;
constexpr int kSmoothings = 2;  // degree of the polynomial, before and after
// Coarse elements are too stiff where struts bend; measured on scaffolds, this saves a fifth of the
// iterations.
constexpr float kOverCorrection = 1.2F;
constexpr int kEigenvalueIterations = 15;
constexpr double kEigenvalueMargin = 1.15;  // what so many iterations leave out

void clear(NodeField<float>& field) {
  forEntries(field.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
    std::fill(field.along[axis].data() + begin, field.along[axis].data() + end, 0.0F);
  });
}

/// Makes the sum of squares over `inverse_weight` 1, and returns its root from before.
double normalise(NodeField<float>& field, const std::vector<float>& inverse_weight) {
  const double length = std::sqrt(sumOverEntries(field.size(), [&](std::size_t axis, std::size_t at) {
    const auto value = static_cast<double>(field.along[axis][at]);
    return value * value / static_cast<double>(inverse_weight[at]);
  }));
  if (length == 0.0) return 0.0;
  const auto scale = static_cast<float>(1.0 / length);
  forEntries(field.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) field.along[axis][at] *= scale;
  });
  return length;
}

float* pointer(NodeField<float>& field, std::size_t axis) { return field.along[axis].data(); }

/// Takes the forces that hold the step off the residual.
void subtractProduct(MultigridLevel& level) {
  addForces(level.elements, -1.0, level.step, level.residual);
  clearGiven(level.residual, level.given);
}

/// By power iteration from noise.
float greatestEigenvalue(MultigridLevel& level) {
  Random random(1);
  for (auto& component : level.step.along)
    for (float& value : component) value = static_cast<float>(random.uniform(-1.0, 1.0));
  clearGiven(level.step, level.given);
  double eigenvalue = normalise(level.step, level.inverse_diagonal);
  for (int i = 0; i < kEigenvalueIterations && eigenvalue > 0.0; ++i) {
    clear(level.residual);
    subtractProduct(level);
    forEntries(level.step.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
      const float* inverse = level.inverse_diagonal.data();
      const float* product = pointer(level.residual, axis);
      float* step = pointer(level.step, axis);
      for (std::size_t at = begin; at < end; ++at) step[at] = inverse[at] * product[at];
    });
    eigenvalue = normalise(level.step, level.inverse_diagonal);
  }
  return eigenvalue > 0.0 ? static_cast<float>(kEigenvalueMargin * eigenvalue) : 1.0F;
}

void smooth(MultigridLevel& level) {
  for (int k = 1; k <= kSmoothings; ++k) {
    const float keep = static_cast<float>(2 * k - 3) / static_cast<float>(2 * k + 1);
    const float take =
        static_cast<float>(8 * k - 4) / (static_cast<float>(2 * k + 1) * level.greatest_eigenvalue);
    const bool is_first = k == 1;
    forEntries(level.step.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
      const float* inverse = level.inverse_diagonal.data();
      const float* residual = pointer(level.residual, axis);
      float* step = pointer(level.step, axis);
      float* solution = pointer(level.solution, axis);
      if (is_first) std::fill(step + begin, step + end, 0.0F);
      for (std::size_t at = begin; at < end; ++at) {
        step[at] = keep * step[at] + take * inverse[at] * residual[at];
        solution[at] += step[at];
      }
    });
    subtractProduct(level);
  }
}

}  // namespace

Multigrid::Multigrid(const ElasticElements& elements, const GivenNodes& given) {
  addLevel(elements, given);
  while (levels_.back().elements.lattice.nodeCount() > kCoarsestNodes) {
    const MultigridLevel& fine = levels_.back();
    const ElementLattice& lattice = fine.elements.lattice;
    coarser_.push_back(std::make_unique<ElementLattice>(ElementLattice::coarsened(lattice)));
    const ElementLattice& coarse = *coarser_.back();
    addLevel({coarse, elements.material, 2.0 * fine.elements.element_mm},
             givenOnCoarse(lattice, fine.given, coarse));
  }
  coarsest_ = std::make_unique<CoarseFactor>(levels_.back().elements, levels_.back().given);
}

void Multigrid::addLevel(const ElasticElements& elements, GivenNodes given) {
  const std::int32_t nodes = elements.lattice.nodeCount();
  levels_.push_back({elements, std::move(given), 0.0F, densityAround(elements.lattice),
                     NodeField<float>(nodes), NodeField<float>(nodes), NodeField<float>(nodes)});
  MultigridLevel& level = levels_.back();
  const double whole = diagonalOfElement(elements.material, elements.element_mm);
  for (float& density : level.inverse_diagonal)
    density = static_cast<float>(1.0 / (whole * static_cast<double>(density)));
  level.greatest_eigenvalue = greatestEigenvalue(level);
}

/// Adds what the coarser lattice makes of the residual.
void Multigrid::correct(std::size_t at) {
  MultigridLevel& level = levels_[at];
  MultigridLevel& coarse = levels_[at + 1];
  gatherForces(level.elements.lattice, level.residual, coarse.elements.lattice, coarse.residual);
  clearGiven(coarse.residual, coarse.given);
  solve(at + 1);
  clear(level.step);
  addInterpolated(coarse.elements.lattice, coarse.solution, level.elements.lattice, level.step);
  clearGiven(level.step, level.given);
  forEntries(level.step.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
    float* step = pointer(level.step, axis);
    float* solution = pointer(level.solution, axis);
    for (std::size_t i = begin; i < end; ++i) solution[i] += step[i] *= kOverCorrection;
  });
  subtractProduct(level);
}

void Multigrid::solve(std::size_t at) {
  MultigridLevel& level = levels_[at];
  if (at + 1 == levels_.size()) {
    coarsest_->solve(level.residual, level.solution);
    return;
  }
  clear(level.solution);
  smooth(level);
  const int visits = at == 0 ? 1 : 2;
  for (int visit = 0; visit < visits; ++visit) {
    correct(at);
    smooth(level);
  }
}

const NodeField<float>& Multigrid::operator()(const NodeField<double>& force, double scale) {
  MultigridLevel& level = levels_.front();
  forEntries(force.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
    const double* from = force.along[axis].data();
    float* residual = pointer(level.residual, axis);
    for (std::size_t at = begin; at < end; ++at) residual[at] = static_cast<float>(scale * from[at]);
  });
  solve(0);
  return level.solution;
}

}  // namespace lamina
