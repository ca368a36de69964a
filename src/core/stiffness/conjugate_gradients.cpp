// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>

#include "stiffness/matrix_free_operator.hpp"
#include "stiffness/multigrid.hpp"
#include "stiffness/node_blocks.hpp"

namespace lamina {
namespace {

template <class A, class B>
double dot(const NodeField<A>& a, const NodeField<B>& b) {
  return sumOverEntries(a.size(), [&](std::size_t axis, std::size_t at) {
    return static_cast<double>(a.along[axis][at]) * static_cast<double>(b.along[axis][at]);
  });
}

double length(const NodeField<double>& field) { return std::sqrt(dot(field, field)); }

/// to = keep * to + add * from
template <class From>
void combine(double keep, NodeField<double>& to, double add, const NodeField<From>& from) {
  forEntries(to.size(), [&](std::size_t axis, std::size_t begin, std::size_t end) {
    const From* source = from.along[axis].data();
    double* target = to.along[axis].data();
    for (std::size_t at = begin; at < end; ++at)
      target[at] = keep * target[at] + add * static_cast<double>(source[at]);
  });
}

}  // namespace

Iteration balance(const ElasticProblem& problem, const IterationLimits& limits,
                  NodeField<double>& displacement, Progress& progress) {
  const ElementLattice& lattice = problem.elements.lattice;
  NodeField<double> residual(lattice.nodeCount());
  addForces(problem.elements, -1.0, displacement, residual);
  clearGiven(residual, problem.given);
  const double start = length(residual);
  Iteration reached;
  if (start == 0.0) return reached;
  Multigrid precondition(problem.elements, problem.given);
  NodeField<double> direction(lattice.nodeCount());
  NodeField<double> product(lattice.nodeCount());
  double before = 0.0;
  reached.residual = 1.0;
  while (reached.residual > limits.residual && reached.count < limits.iterations) {
    throwIfCancelled(progress, "solve");
    // Scaled, so that single precision holds it.
    const double size = reached.residual * start;
    const NodeField<float>& step = precondition(residual, 1.0 / size);
    const double along = dot(residual, step) * size;
    combine(before == 0.0 ? 0.0 : along / before, direction, size, step);
    before = along;
    fill(product, 0.0);
    addForces(problem.elements, 1.0, direction, product);
    clearGiven(product, problem.given);
    const double stride = along / dot(direction, product);
    combine(1.0, displacement, stride, direction);
    combine(1.0, residual, -stride, product);
    reached.residual = length(residual) / start;
    ++reached.count;
    progress.report("solve", std::clamp(std::log(reached.residual) / std::log(limits.residual), 0.0, 1.0));
  }
  return reached;
}

}  // namespace lamina
