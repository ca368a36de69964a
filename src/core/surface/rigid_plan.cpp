// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/rigid_plan.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace lamina {
namespace {

using Complex = std::complex<double>;

constexpr int kIterations = 30;
// Iterations end when one lessens the sum by less than this share of it.
constexpr double kConverged = 1e-3;
// Bounds on cotangents, for triangles that are nearly lines.
constexpr double kLeastWeight = 0.01;
constexpr double kGreatestWeight = 100.0;

/// A triangle laid flat by itself: its sides as vectors, and how much each of them counts.
struct FlatTriangle {
  std::array<Complex, 3> side;
  std::array<double, 3> weight{};
};

FlatTriangle layFlat(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a;
  const Point3 ac = c - a;
  const double length = ab.norm();
  const double area = ab.cross(ac).norm();
  FlatTriangle flat;
  const Complex corner_b(length, 0.0);
  const Complex corner_c =
      length > 0.0 ? Complex(ab.dot(ac) / length, area / length) : Complex(0.0, ac.norm());
  flat.side = {corner_b, corner_c - corner_b, -corner_c};
  for (std::size_t i = 0; i < 3; ++i) {
    // Of the two sides that meet across this one; one comes in there, the other goes out.
    const double dot = -(flat.side[(i + 1) % 3] * std::conj(flat.side[(i + 2) % 3])).real();
    flat.weight[i] = area > 0.0 ? std::clamp(dot / area, kLeastWeight, kGreatestWeight) : kLeastWeight;
  }
  return flat;
}

/// Alternates between the best turn of each triangle in the plan and the best plan for these turns.
class RigidRelaxation {
 public:
  RigidRelaxation(const Mesh& surface, const std::vector<Point2>& guess)
      : surface_(surface), plan_(static_cast<Eigen::Index>(guess.size()), 2) {
    for (std::size_t i = 0; i < guess.size(); ++i) plan_.row(static_cast<Eigen::Index>(i)) = guess[i];
    flat_.reserve(surface.triangles.size());
    for (const Triangle& corner : surface.triangles)
      flat_.push_back(
          layFlat(surface.vertices[corner[0]], surface.vertices[corner[1]], surface.vertices[corner[2]]));
  }

  std::vector<Point2> run() && {
    factorise();
    double before = turnTriangles();
    for (int i = 0; i < kIterations; ++i) {
      plan_.bottomRows(plan_.rows() - 1) = solver_.solve(pull_.bottomRows(plan_.rows() - 1));
      plan_.row(0).setZero();
      const double after = turnTriangles();
      if (!(after < (1.0 - kConverged) * before)) break;
      before = after;
    }
    std::vector<Point2> plan;
    plan.reserve(static_cast<std::size_t>(plan_.rows()));
    for (Eigen::Index i = 0; i < plan_.rows(); ++i) plan.emplace_back(plan_.row(i));
    return plan;
  }

 private:
  Complex at(std::uint32_t vertex) const { return {plan_(vertex, 0), plan_(vertex, 1)}; }

  /// Vertex 0 stays at the origin, which makes the plan unique.
  void factorise() {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * surface_.triangles.size());
    const auto add = [&entries](std::uint32_t row, std::uint32_t column, double value) {
      if (row > 0 && column > 0 && row >= column)
        entries.emplace_back(static_cast<int>(row) - 1, static_cast<int>(column) - 1, value);
    };
    for (std::size_t t = 0; t < flat_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = surface_.triangles[t][i];
        const std::uint32_t to = surface_.triangles[t][(i + 1) % 3];
        const double weight = flat_[t].weight[i];
        add(from, from, weight);
        add(to, to, weight);
        add(std::max(from, to), std::min(from, to), -weight);
      }
    Eigen::SparseMatrix<double> matrix(plan_.rows() - 1, plan_.rows() - 1);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
  }

  /// Turns each triangle as it lies in the plan.
  /// @return the sum that is to be least
  double turnTriangles() {
    pull_.setZero(plan_.rows(), 2);
    double sum = 0.0;
    for (std::size_t t = 0; t < flat_.size(); ++t) {
      const Triangle& corner = surface_.triangles[t];
      const FlatTriangle& flat = flat_[t];
      const std::array<Complex, 3> place = {at(corner[0]), at(corner[1]), at(corner[2])};
      Complex turn = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
        turn += flat.weight[i] * (place[(i + 1) % 3] - place[i]) * std::conj(flat.side[i]);
      const double size = std::abs(turn);
      turn = size > 0.0 ? turn / size : Complex(1.0, 0.0);
      for (std::size_t i = 0; i < 3; ++i) {
        const Complex side = turn * flat.side[i];
        sum += flat.weight[i] * std::norm(place[(i + 1) % 3] - place[i] - side);
        const Eigen::RowVector2d pull(flat.weight[i] * side.real(), flat.weight[i] * side.imag());
        pull_.row(corner[(i + 1) % 3]) += pull;
        pull_.row(corner[i]) -= pull;
      }
    }
    return sum;
  }

  const Mesh& surface_;
  std::vector<FlatTriangle> flat_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> plan_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> pull_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace

std::vector<Point2> relaxRigidly(const Mesh& surface, std::vector<Point2> guess) {
  if (guess.size() < 3) return guess;
  return RigidRelaxation(surface, guess).run();
}

}  // namespace lamina
