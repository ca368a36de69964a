// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/stress_recovery.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Core>
#include <cmath>

namespace lamina {
namespace {

/// Mean derivatives of the displacement over an element: column a is that along axis a, times four sides.
Eigen::Matrix3d fourGradients(const ElementRun& run, std::int32_t i, const NodeField<double>& displacement) {
  Eigen::Matrix3d gradients = Eigen::Matrix3d::Zero();
  for (std::size_t c = 0; c < 8; ++c) {
    const auto node = static_cast<std::size_t>(run.node[c / 2] + i) + c % 2;
    const Eigen::Vector3d u(displacement.along[0][node], displacement.along[1][node],
                            displacement.along[2][node]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      gradients.col(Eigen::Index(axis)) += (c >> axis & 1U) != 0 ? u : Eigen::Vector3d(-u);
  }
  return gradients;
}

Stress stressAt(const Eigen::Matrix3d& gradients, const ElasticMaterial& material) {
  const double pressure = material.lambda() * gradients.trace();
  const Eigen::Matrix3d stress =
      material.mu() * (gradients + gradients.transpose()) + pressure * Eigen::Matrix3d::Identity();
  return {float(stress(0, 0)), float(stress(1, 1)), float(stress(2, 2)),
          float(stress(0, 1)), float(stress(1, 2)), float(stress(2, 0))};
}

}  // namespace

float Stress::vonMises() const {
  const float normal = (xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx);
  return std::sqrt(0.5F * normal + 3.0F * (xy * xy + yz * yz + zx * zx));
}

std::vector<Stress> stressOf(const ElementLattice& lattice, const ElasticMaterial& material,
                             double element_mm, const NodeField<double>& displacement) {
  std::vector<Stress> stress(static_cast<std::size_t>(lattice.elementCount()));
  tbb::parallel_for(std::size_t{0}, lattice.runCount(), [&](std::size_t r) {
    const ElementRun& run = lattice.elementsBegin(0)[r];
    // A 0 stands after each run before it.
    const std::size_t first = std::size_t(run.column) - r;
    for (std::int32_t i = 0; i < run.count; ++i)
      stress[first + std::size_t(i)] =
          stressAt(fourGradients(run, i, displacement) / (4.0 * element_mm), material);
  });
  return stress;
}

}  // namespace lamina
