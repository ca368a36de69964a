// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/arap_energy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

using Rotation2 = std::complex<double>;

// Triangles count as if they were at least as high as this share of their longest side: the cotangents of
// slivers would drown all others.
constexpr double kLeastHeight = 0.01;

/// Cotangents of the angles across the sides.
std::array<double, 3> cotangents(const std::array<Rotation2, 3>& side, double double_area) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::norm(side[i]) > std::norm(side[longest])) longest = i;
  const double length = std::abs(side[longest]);
  if (!(length > 0.0)) return {1.0, 1.0, 1.0};
  const double height = std::max(double_area / length, kLeastHeight * length);
  const double foot = -(side[longest] * std::conj(side[(longest + 2) % 3])).real() / length;
  std::array<double, 3> cotangent{};
  cotangent[longest] = (height * height - foot * (length - foot)) / (length * height);
  cotangent[(longest + 1) % 3] = foot / height;
  cotangent[(longest + 2) % 3] = (length - foot) / height;
  return cotangent;
}

ArapEnergy::FlatTriangle layFlat(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a;
  const Point3 ac = c - a;
  const double length = ab.norm();
  const double double_area = ab.cross(ac).norm();
  ArapEnergy::FlatTriangle flat;
  const Rotation2 corner_b(length, 0.0);
  const Rotation2 corner_c =
      length > 0.0 ? Rotation2(ab.dot(ac) / length, double_area / length) : Rotation2(0.0, ac.norm());
  flat.side = {corner_b, corner_c - corner_b, -corner_c};
  flat.weight = cotangents(flat.side, double_area);
  return flat;
}

Rotation2 asComplex(const Point2& vector) { return {vector.x(), vector.y()}; }

}  // namespace

ArapEnergy::ArapEnergy(const Mesh& surface) : surface_(surface) {
  triangles_.reserve(surface.triangles.size());
  for (const Triangle& corner : surface.triangles)
    triangles_.push_back(
        layFlat(surface.vertices[corner[0]], surface.vertices[corner[1]], surface.vertices[corner[2]]));
}

ArapEnergy::Pull ArapEnergy::pullOn(const std::vector<Point2>& parameterization) const {
  Pull pull;
  pull.at_vertex.assign(parameterization.size(), Point2::Zero());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& corner = surface_.triangles[t];
    const FlatTriangle& flat = triangles_[t];
    std::array<Rotation2, 3> side;
    Rotation2 turn = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      side[i] = asComplex(parameterization[corner[(i + 1) % 3]] - parameterization[corner[i]]);
      turn += flat.weight[i] * side[i] * std::conj(flat.side[i]);
    }
    const double size = std::sqrt(std::norm(turn));
    turn = size > 0.0 ? turn / size : Rotation2(1.0, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rotation2 error = turn * flat.side[i] - side[i];
      pull.energy += flat.weight[i] * std::norm(error);
      const Point2 force(flat.weight[i] * error.real(), flat.weight[i] * error.imag());
      pull.at_vertex[corner[(i + 1) % 3]] += force;
      pull.at_vertex[corner[i]] -= force;
    }
  }
  return pull;
}

}  // namespace lamina
