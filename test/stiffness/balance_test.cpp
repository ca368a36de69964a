// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "lamina/base/error.hpp"
#include "stiffness/conjugate_gradients.hpp"
#include "stiffness/lattice_transfer.hpp"
#include "stiffness/matrix_free_operator.hpp"
#include "support/voxel_shapes.hpp"

namespace lamina {
namespace {

constexpr ElasticMaterial kMaterial{3861.0, 0.35};

ElementLattice latticeOf(const VoxelGrid& grid) { return {grid, {{0, 0, 0}, grid.frame().count}}; }

/// Calls body(node, place) for each node, its place counted in elements.
template <class Body>
void forPlaces(const ElementLattice& lattice, const Body& body) {
  for (int k = 0; k <= lattice.count()[2]; ++k)
    for (int j = 0; j <= lattice.count()[1]; ++j)
      for (int i = 0; i <= lattice.count()[0]; ++i)
        if (const std::int32_t node = lattice.nodeAt(i, j, k); node >= 0)
          body(std::size_t(node), Point3(i, j, k));
}

// The patch test: what is displaced linearly on its surface is displaced linearly within.
TEST(Balance, DisplacesAPatchLinearly) {
  const ElementLattice lattice = latticeOf(test::gyroid(40, 0.25));
  const std::vector<float> around = densityAround(lattice);
  Eigen::Matrix3d gradient;
  gradient << 0.01, -0.02, 0.005, 0.03, 0.015, -0.01, 0.02, 0.004, -0.03;
  GivenNodes given;
  NodeField<double> u(lattice.nodeCount());
  forPlaces(lattice, [&](std::size_t node, const Point3& place) {
    if (around[node] == 8.0F) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      given[axis].push_back(std::int32_t(node));
      u.along[axis][node] = (gradient * place)[Eigen::Index(axis)];
    }
  });
  NoProgress progress;
  const Iteration reached = balance({{lattice, kMaterial, 0.25}, given}, {1e-12, 100}, u, progress);
  EXPECT_LE(reached.residual, 1e-12);
  forPlaces(lattice, [&](std::size_t node, const Point3& place) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(u.along[axis][node], (gradient * place)[Eigen::Index(axis)], 1e-9);
  });
}

/// Cancels the work when it is asked for the n-th time.
class CancelledAt final : public Progress {
 public:
  explicit CancelledAt(int look) : look_(look) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return ++looks_ >= look_; }
  int looks() const { return looks_; }

 private:
  int look_;
  mutable int looks_ = 0;
};

// Fifteen passes of the power iteration on the finest lattice alone, and two smoothings before and after the
// coarser ones, come before the first iteration ends: each pass over a large lattice takes a second.
TEST(Balance, CanBeCancelledBeforeEachPassOfItsFirstIteration) {
  const ElementLattice lattice = latticeOf(test::solidBox({12, 12, 12}, 1.0));
  ASSERT_GT(lattice.nodeCount(), 1500) << "has a coarser lattice";
  GivenNodes given;
  NodeField<double> at_start(lattice.nodeCount());
  forPlaces(lattice, [&](std::size_t node, const Point3& place) {
    if (place.z() > 0.0 && place.z() < 12.0) return;
    for (std::size_t axis = 0; axis < 3; ++axis) given[axis].push_back(std::int32_t(node));
    at_start.along[2][node] = -0.01 * place.z();
  });
  for (int look = 1; look <= 15 + 2 + 2; ++look) {
    CancelledAt progress(look);
    NodeField<double> u = at_start;
    EXPECT_THROW(balance({{lattice, kMaterial, 1.0}, given}, {1e-6, 1}, u, progress), Cancelled);
    EXPECT_EQ(progress.looks(), look);
  }
}

TEST(LatticeTransfer, InterpolatesLinearFieldsExactly) {
  const ElementLattice fine = latticeOf(test::noise({21, 14, 9}, 0.5, 5));
  const ElementLattice coarse = ElementLattice::coarsened(fine);
  NodeField<float> on_coarse(coarse.nodeCount());
  forPlaces(coarse, [&](std::size_t node, const Point3& p) {
    on_coarse.along[0][node] = float(2.0 * p.x());
    on_coarse.along[1][node] = float(2.0 * p.y());
    on_coarse.along[2][node] = float(2.0 * p.z());
  });
  NodeField<float> on_fine(fine.nodeCount());
  addInterpolated(coarse, on_coarse, fine, on_fine);
  forPlaces(fine, [&](std::size_t node, const Point3& p) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_EQ(on_fine.along[axis][node], float(p[Eigen::Index(axis)]));
  });
}

TEST(LatticeTransfer, GathersByTheTransposeOfInterpolation) {
  const ElementLattice fine = latticeOf(test::noise({21, 14, 9}, 0.5, 6));
  const ElementLattice coarse = ElementLattice::coarsened(fine);
  Random random(1);
  const auto noise = [&](std::int32_t nodes) {
    NodeField<float> field(nodes);
    for (auto& component : field.along)
      for (float& value : component) value = float(random.uniform(-1.0, 1.0));
    return field;
  };
  const auto dot = [](const NodeField<float>& a, const NodeField<float>& b) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < a.size(); ++i) sum += double(a.along[axis][i]) * double(b.along[axis][i]);
    return sum;
  };
  const NodeField<float> a = noise(coarse.nodeCount());
  const NodeField<float> b = noise(fine.nodeCount());
  NodeField<float> interpolated(fine.nodeCount());
  addInterpolated(coarse, a, fine, interpolated);
  NodeField<float> gathered(coarse.nodeCount());
  gatherForces(fine, b, coarse, gathered);
  EXPECT_NEAR(dot(interpolated, b), dot(a, gathered), 1e-3);
}

TEST(ElementLattice, KeepsTheVolumeWhenCoarsened) {
  const ElementLattice fine = latticeOf(test::noise({21, 14, 9}, 0.3, 8));
  const ElementLattice coarse = ElementLattice::coarsened(fine);
  double sum = 0.0;
  for (const float density : coarse.density()) sum += double(density);
  EXPECT_DOUBLE_EQ(8.0 * sum, double(fine.elementCount()));
}

}  // namespace
}  // namespace lamina
