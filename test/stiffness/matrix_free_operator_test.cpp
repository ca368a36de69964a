// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/matrix_free_operator.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "lamina/stiffness/element_stiffness.hpp"
#include "support/voxel_shapes.hpp"

namespace lamina {
namespace {

constexpr ElasticMaterial kMatrixFreeOperatorMaterial{3861.0, 0.35};

ElementLattice matrixFreeOperatorLatticeOf(const VoxelGrid& grid) {
  return {grid, {{0, 0, 0}, grid.frame().count}};
}

/// Stiffness by Gauss's quadrature with two points along each axis, from the strains of the corner functions.
ElementMatrix byQuadrature(const ElasticMaterial& material, double h) {
  Eigen::Matrix<double, 6, 6> elastic = Eigen::Matrix<double, 6, 6>::Zero();
  elastic.topLeftCorner<3, 3>().setConstant(material.lambda());
  elastic.diagonal() << Eigen::Vector3d::Constant(material.lambda() + 2.0 * material.mu()),
      Eigen::Vector3d::Constant(material.mu());
  ElementMatrix sum = ElementMatrix::Zero();
  for (int point = 0; point < 8; ++point) {
    const auto at = [&](int axis) { return 0.5 + ((point >> axis & 1) == 1 ? 0.5 : -0.5) / std::sqrt(3.0); };
    Eigen::Matrix<double, 6, 24> strain = Eigen::Matrix<double, 6, 24>::Zero();
    for (int c = 0; c < 8; ++c) {
      Eigen::Vector3d gradient;
      for (int along = 0; along < 3; ++along) {
        gradient[along] = 1.0 / h;
        for (int axis = 0; axis < 3; ++axis) {
          const bool is_high = (c >> axis & 1) == 1;
          gradient[along] *= axis == along ? (is_high ? 1.0 : -1.0) : (is_high ? at(axis) : 1.0 - at(axis));
        }
      }
      const auto [x, y, z] = std::array<double, 3>{gradient.x(), gradient.y(), gradient.z()};
      strain.block<6, 3>(0, Eigen::Index{3} * c) << x, 0, 0, 0, y, 0, 0, 0, z, y, x, 0, 0, z, y, z, 0, x;
    }
    sum += strain.transpose() * elastic * strain * (h * h * h / 8.0);
  }
  return sum;
}

NodeField<double> randomField(const ElementLattice& lattice) {
  Random random(7);
  NodeField<double> field(lattice.nodeCount());
  for (auto& component : field.along)
    for (double& value : component) value = random.uniform(-1.0, 1.0);
  return field;
}

/// The product by the matrix of each element.
NodeField<double> assembledProduct(const ElementLattice& lattice, double element_mm,
                                   const NodeField<double>& u) {
  const ElementMatrix stiffness = elementStiffness(kMatrixFreeOperatorMaterial, element_mm);
  NodeField<double> force(lattice.nodeCount());
  const int rows = lattice.count()[1] * lattice.count()[2];
  for (const ElementRun* run = lattice.elementsBegin(0); run != lattice.elementsEnd(rows - 1); ++run)
    for (int i = 0; i < run->count; ++i) {
      const auto node = [&](int c) {
        return std::size_t(run->node[std::size_t(c / 2)]) + std::size_t(i + c % 2);
      };
      Eigen::Matrix<double, 24, 1> local;
      for (int c = 0; c < 8; ++c)
        for (int a = 0; a < 3; ++a) local[3 * c + a] = u.along[std::size_t(a)][node(c)];
      const Eigen::Matrix<double, 24, 1> product = stiffness * local;
      for (int c = 0; c < 8; ++c)
        for (int a = 0; a < 3; ++a) force.along[std::size_t(a)][node(c)] += product[3 * c + a];
    }
  return force;
}

TEST(ElementStiffness, IsThatOfGaussianQuadrature) {
  const ElementMatrix stiffness = elementStiffness(kMatrixFreeOperatorMaterial, 0.05);
  EXPECT_LT((stiffness - byQuadrature(kMatrixFreeOperatorMaterial, 0.05)).norm(), 1e-12 * stiffness.norm());
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-14 * stiffness.norm());
}

TEST(ElementStiffness, HasSixRigidMotionsAndNoOther) {
  const Eigen::SelfAdjointEigenSolver<ElementMatrix> solver(
      elementStiffness(kMatrixFreeOperatorMaterial, 1.0));
  EXPECT_LT(std::abs(solver.eigenvalues()[5]), 1e-9);
  EXPECT_GT(solver.eigenvalues()[6], 1.0);
}

TEST(MatrixFreeOperator, IsThatOfTheMatrixOfEachElement) {
  const VoxelGrid grid = test::noise({150, 9, 11}, 0.6, 3);
  const ElementLattice lattice = matrixFreeOperatorLatticeOf(grid);
  const NodeField<double> u = randomField(lattice);
  NodeField<double> force(lattice.nodeCount());
  addForces<double>({lattice, kMatrixFreeOperatorMaterial, 0.4}, 1.0, u, force);
  const NodeField<double> expected = assembledProduct(lattice, 0.4, u);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t node = 0; node < force.size(); ++node)
      ASSERT_NEAR(force.along[axis][node], expected.along[axis][node], 1e-9);
}

TEST(MatrixFreeOperator, OfRigidMotionsIsNothing) {
  const VoxelGrid grid = test::gyroid(24, 0.5);
  const ElementLattice lattice = matrixFreeOperatorLatticeOf(grid);
  NodeField<double> u(lattice.nodeCount());
  for (int k = 0; k <= 24; ++k)
    for (int j = 0; j <= 24; ++j)
      for (int i = 0; i <= 24; ++i) {
        const std::int32_t node = lattice.nodeAt(i, j, k);
        if (node < 0) continue;
        const Point3 moved = Point3(1, 2, 3) + 0.5 * Point3(0.1, -0.2, 0.3).cross(Point3(i, j, k));
        for (std::size_t axis = 0; axis < 3; ++axis)
          u.along[axis][std::size_t(node)] = moved[Eigen::Index(axis)];
      }
  NodeField<double> force(lattice.nodeCount());
  addForces<double>({lattice, kMatrixFreeOperatorMaterial, 0.5}, 1.0, u, force);
  for (const auto& component : force.along)
    for (const double value : component) ASSERT_NEAR(value, 0.0, 1e-9);
}

TEST(MatrixFreeOperator, ReportsItsDiagonal) {
  EXPECT_NEAR(diagonalOfElement(kMatrixFreeOperatorMaterial, 0.7),
              elementStiffness(kMatrixFreeOperatorMaterial, 0.7)(4, 4), 1e-9);
}

}  // namespace
}  // namespace lamina
