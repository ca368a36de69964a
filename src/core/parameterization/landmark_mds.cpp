// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/landmark_mds.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/dense_solvers.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

// Up to this size all eigenvalues are had at once.
constexpr Eigen::Index kSmall = 200;
constexpr int kPowerIterations = 100;

struct Axes {
  Eigen::Vector2d values;                            // the two greatest
  Eigen::Matrix<double, Eigen::Dynamic, 2> vectors;  // of unit length
};

Axes lastTwo(const Eigen::VectorXd& ascending, const Eigen::MatrixXd& vectors) {
  const Eigen::Index last = ascending.size() - 1;
  Axes axes;
  axes.values << ascending[last], ascending[last - 1];
  axes.vectors.resize(vectors.rows(), 2);
  axes.vectors << vectors.col(last), vectors.col(last - 1);
  return axes;
}

/// The two greatest eigenvalues of a symmetric matrix, by orthogonal iteration on a few vectors if it is
/// large.
Axes greatestAxes(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() <= kSmall) {
    const SymmetricParts parts = symmetricParts(matrix);
    return lastTwo(parts.values, parts.vectors);
  }
  constexpr Eigen::Index kVectors = 6;
  Eigen::MatrixXd basis(matrix.rows(), kVectors);
  for (Eigen::Index i = 0; i < basis.rows(); ++i)
    for (Eigen::Index j = 0; j < kVectors; ++j)
      basis(i, j) = std::cos(static_cast<double>((i + 1) * (j + 1)));
  SymmetricParts parts;
  Eigen::Vector2d previous = Eigen::Vector2d::Zero();
  for (int i = 0; i < kPowerIterations; ++i) {
    const Eigen::MatrixXd spread = matrix * basis;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(spread);
    basis = qr.householderQ() * Eigen::MatrixXd::Identity(matrix.rows(), kVectors);
    parts = symmetricParts(basis.transpose() * matrix * basis);
    const Eigen::Vector2d greatest = parts.values.tail<2>();
    if ((greatest - previous).norm() <= 1e-12 * greatest.norm()) break;
    previous = greatest;
  }
  return lastTwo(parts.values, basis * parts.vectors);
}

}  // namespace

Landmarks spreadLandmarks(const GeodesicDistances& geodesics, std::size_t vertices, std::size_t count) {
  Landmarks landmarks;
  std::vector<double> nearest = geodesics.from(0);
  for (std::size_t i = 0; i < std::min(count, vertices); ++i) {
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    if (std::isinf(*farthest))
      throw InvalidMesh("no way over the surface leads to vertex " +
                        std::to_string(farthest - nearest.begin()) + "; expected one connected piece");
    const auto vertex = static_cast<std::uint32_t>(farthest - nearest.begin());
    landmarks.vertices.push_back(vertex);
    landmarks.distance.push_back(geodesics.from(vertex));
    if (i == 0) nearest.assign(vertices, std::numeric_limits<double>::max());
    for (std::size_t v = 0; v < vertices; ++v)
      nearest[v] = std::min(nearest[v], landmarks.distance.back()[v]);
  }
  return landmarks;
}

std::vector<Point2> landmarkMds(const Landmarks& landmarks) {
  const auto count = static_cast<Eigen::Index>(landmarks.vertices.size());
  Eigen::MatrixXd squared(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      squared(i, j) = std::pow(
          landmarks.distance[static_cast<std::size_t>(i)][landmarks.vertices[static_cast<std::size_t>(j)]],
          2);
  squared = (0.5 * (squared + squared.transpose())).eval();
  const Eigen::VectorXd mean = squared.rowwise().mean();
  const Eigen::MatrixXd centred =
      -0.5 * ((squared.colwise() - mean).rowwise() - mean.transpose()).array() - 0.5 * mean.mean();
  const Axes axes = greatestAxes(centred);
  Eigen::Matrix<double, 2, Eigen::Dynamic> place(2, count);  // of a vertex from its squared distances
  for (int k = 0; k < 2; ++k)
    place.row(k) =
        axes.values[k] > 0.0
            ? Eigen::RowVectorXd(-0.5 / std::sqrt(axes.values[k]) * axes.vectors.col(k).transpose())
            : Eigen::RowVectorXd::Zero(count);
  std::vector<Point2> parameterization(landmarks.distance.front().size(), Point2(-(place * mean)));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Point2 share = place.col(i);
    const std::vector<double>& distance = landmarks.distance[static_cast<std::size_t>(i)];
    for (std::size_t v = 0; v < parameterization.size(); ++v)
      parameterization[v] += distance[v] * distance[v] * share;
  }
  return parameterization;
}

}  // namespace lamina
