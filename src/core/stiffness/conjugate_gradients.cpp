// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/conjugate_gradients.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "conjugate_gradients.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/stiffness/element_stiffness.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "lattice_transfer.hpp"
#include "matrix_free_operator.hpp"

namespace lamina {
namespace {

/// Numbers dealt with by one task. The division does not depend on the number of threads, so sums do not.
inline constexpr std::size_t kBlock = 16384;

/// Calls body(begin, end) for the blocks of [0, count), at the same time.
template <class Body>
void forBlocks(std::size_t count, const Body& body) {
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  parallelFor(blocks, [&](std::size_t b) { body(b * kBlock, std::min(count, (b + 1) * kBlock)); });
}

/// Calls body(axis, begin, end) for the components of blocks of [0, count), at the same time.
template <class Body>
void forEntries(std::size_t count, const Body& body) {
  forBlocks(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = 0; axis < 3; ++axis) body(axis, begin, end);
  });
}

/// The sum of body(axis, at) over all components of [0, count), in the same order whatever the threads.
template <class Body>
double sumOverEntries(std::size_t count, const Body& body) {
  std::vector<double> sums((count + kBlock - 1) / kBlock);
  forBlocks(count, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t at = begin; at < end; ++at) sum += body(axis, at);
    sums[begin / kBlock] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// The stiffness of a small lattice, held and factored.
class CoarseFactor {
 public:
  CoarseFactor(const ElasticElements& elements, const GivenNodes& given);

  /// The displacement that a force causes; 0 where it is given.
  void solve(const NodeField<float>& force, NodeField<float>& displacement) const;

 private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky_;
  std::vector<bool> is_given_;
};

/// One lattice of a multigrid, and what is held on it.
struct MultigridLevel {
  ElasticElements elements;
  GivenNodes given;
  float greatest_eigenvalue = 0.0F;     ///< of the stiffness divided by its diagonal, about
  std::vector<float> inverse_diagonal;  ///< [mm/N]
  NodeField<float> residual;
  NodeField<float> solution;
  NodeField<float> step;
};

/// An approximate inverse of the stiffness of a lattice: one cycle over lattices twice as coarse each, whose
/// elements carry the mean density of what they cover; the finest is visited once, the others twice as often
/// as the one above. Smoothed by Chebyshev polynomials of the fourth kind
/// [Lottes2023], solved by factors at the coarsest. Symmetric, in single
/// precision.
class Multigrid {
 public:
  /// @param elements  their lattice outlives the multigrid
  /// @param given     components of nodes that stay 0
  /// @param progress  outlives the multigrid; asked before each pass over a lattice, which may take a second
  /// @throws Cancelled
  Multigrid(const ElasticElements& elements, const GivenNodes& given, const Progress& progress);

  /// Roughly the displacement that `scale` times a force causes.
  /// @param force  0 where displacements are given
  /// @throws Cancelled
  const NodeField<float>& operator()(const NodeField<double>& force, double scale);

 private:
  void addLevel(const ElasticElements& elements, GivenNodes given);
  void solve(std::size_t at);
  void correct(std::size_t at);

  const Progress& progress_;
  std::vector<std::unique_ptr<const ElementLattice>> coarser_;
  std::vector<MultigridLevel> levels_;
  std::unique_ptr<const CoarseFactor> coarsest_;
};

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

constexpr const char* kSolving = "solve";  // the stage of progress
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
float greatestEigenvalue(MultigridLevel& level, const Progress& progress) {
  Random random(1);
  for (auto& component : level.step.along)
    for (float& value : component) value = static_cast<float>(random.uniform(-1.0, 1.0));
  clearGiven(level.step, level.given);
  double eigenvalue = normalise(level.step, level.inverse_diagonal);
  for (int i = 0; i < kEigenvalueIterations && eigenvalue > 0.0; ++i) {
    throwIfCancelled(progress, kSolving);
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

void smooth(MultigridLevel& level, const Progress& progress) {
  for (int k = 1; k <= kSmoothings; ++k) {
    throwIfCancelled(progress, kSolving);
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

CoarseFactor::CoarseFactor(const ElasticElements& elements, const GivenNodes& given) {
  const ElementLattice& lattice = elements.lattice;
  const std::size_t unknowns = 3 * std::size_t(lattice.nodeCount());
  is_given_.resize(unknowns);
  Entries entries;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::int32_t node : given[axis]) {
      is_given_[3 * std::size_t(node) + axis] = true;
      entries.emplace_back(3 * node + int(axis), 3 * node + int(axis), 1.0);
    }
  const ElementMatrix stiffness = elementStiffness(elements.material, elements.element_mm);
  for (int row = 0; row < lattice.count()[1] * lattice.count()[2]; ++row)
    for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run)
      for (std::int32_t i = 0; i < run->count; ++i) {
        std::array<std::int32_t, 8> node{};
        for (std::size_t c = 0; c < 8; ++c) node[c] = run->node[c / 2] + i + std::int32_t(c % 2);
        addElement(stiffness, double(lattice.density().data()[run->column + i]), node, is_given_, entries);
      }
  Eigen::SparseMatrix<double> matrix{Eigen::Index(unknowns), Eigen::Index(unknowns)};
  matrix.setFromTriplets(entries.begin(), entries.end());
  cholesky_.compute(matrix);
  if (cholesky_.info() != Eigen::Success)
    throw InvalidInput("stiffness of the coarsest lattice has no factors; what bears the load must be held");
}

void CoarseFactor::solve(const NodeField<float>& force, NodeField<float>& displacement) const {
  Eigen::VectorXd right(Eigen::Index(3 * force.size()));
  for (std::size_t node = 0; node < force.size(); ++node)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = 3 * node + axis;
      right[Eigen::Index(at)] = is_given_[at] ? 0.0 : double(force.along[axis][node]);
    }
  const Eigen::VectorXd solved = cholesky_.solve(right);
  for (std::size_t node = 0; node < force.size(); ++node)
    for (std::size_t axis = 0; axis < 3; ++axis)
      displacement.along[axis][node] = float(solved[Eigen::Index(3 * node + axis)]);
}

Multigrid::Multigrid(const ElasticElements& elements, const GivenNodes& given, const Progress& progress)
    : progress_(progress) {
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
  level.greatest_eigenvalue = greatestEigenvalue(level, progress_);
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
  smooth(level, progress_);
  const int visits = at == 0 ? 1 : 2;
  for (int visit = 0; visit < visits; ++visit) {
    correct(at);
    smooth(level, progress_);
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
  Multigrid precondition(problem.elements, problem.given, progress);
  NodeField<double> direction(lattice.nodeCount());
  NodeField<double> product(lattice.nodeCount());
  double before = 0.0;
  reached.residual = 1.0;
  while (reached.residual > limits.residual && reached.count < limits.iterations) {
    throwIfCancelled(progress, kSolving);
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
    progress.report(kSolving, std::clamp(std::log(reached.residual) / std::log(limits.residual), 0.0, 1.0));
  }
  return reached;
}

}  // namespace lamina
