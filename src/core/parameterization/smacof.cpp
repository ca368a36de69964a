// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameterization/smacof.hpp"

#include <cmath>
#include <cstdint>

namespace lamina {
namespace {

constexpr int kSweeps = 300;
// Sweeps end when ten of them lessen the stress by less than this share of it.
constexpr int kSweepsPerCheck = 10;
constexpr double kStressConverged = 0.01;

/// Calls visit(other, length) for both sides of each triangle at a vertex.
template <class Visit>
void forSides(const TriangleFans& fans, std::uint32_t vertex, const Visit& visit) {
  for (std::uint32_t i = fans.first[vertex]; i < fans.first[vertex + 1]; ++i) {
    visit(fans.corners[i].next, fans.corners[i].to_next);
    visit(fans.corners[i].previous, fans.corners[i].to_previous);
  }
}

template <class Visit>
void forLandmarks(const Landmarks& landmarks, std::uint32_t vertex, const Visit& visit) {
  for (std::size_t i = 0; i < landmarks.vertices.size(); ++i)
    visit(landmarks.vertices[i], landmarks.distance[i][vertex]);
}

/// Where the vertex would be best, seen from the others where they are.
Point2 bestPlace(const std::vector<Point2>& parameterization, std::uint32_t vertex, const TriangleFans& fans,
                 const Landmarks& landmarks) {
  Point2 sum = Point2::Zero();
  double weights = 0.0;
  const auto add = [&](std::uint32_t other, double length, double share) {
    if (!(length > 0.0)) return;
    const Point2 away = parameterization[vertex] - parameterization[other];
    const double distance = away.norm();
    const double weight = share / (length * length);
    sum += weight * (distance > 0.0 ? Point2(parameterization[other] + length / distance * away)
                                    : parameterization[other]);
    weights += weight;
  };
  const double share = 1.0 / static_cast<double>(landmarks.vertices.size());
  forSides(fans, vertex, [&](std::uint32_t other, double length) { add(other, length, 1.0); });
  forLandmarks(landmarks, vertex, [&](std::uint32_t other, double length) { add(other, length, share); });
  return weights > 0.0 ? Point2(sum / weights) : parameterization[vertex];
}

}  // namespace

double stressOf(const std::vector<Point2>& parameterization, const TriangleFans& fans,
                const Landmarks& landmarks) {
  double sides = 0.0;
  double ways = 0.0;
  for (std::uint32_t vertex = 0; vertex < parameterization.size(); ++vertex) {
    const auto squared = [&](std::uint32_t other, double length) {
      const double error =
          length > 0.0 ? (parameterization[vertex] - parameterization[other]).norm() / length - 1.0 : 0.0;
      return error * error;
    };
    // Each side is seen from both ends.
    forSides(fans, vertex,
             [&](std::uint32_t other, double length) { sides += 0.5 * squared(other, length); });
    forLandmarks(landmarks, vertex,
                 [&](std::uint32_t other, double length) { ways += squared(other, length); });
  }
  return sides + ways / static_cast<double>(landmarks.vertices.size());
}

std::vector<Point2> lessenStress(std::vector<Point2> parameterization, const TriangleFans& fans,
                                 const Landmarks& landmarks) {
  double before = stressOf(parameterization, fans, landmarks);
  for (int sweep = 1; sweep <= kSweeps; ++sweep) {
    for (std::uint32_t vertex = 0; vertex < parameterization.size(); ++vertex)
      parameterization[vertex] = bestPlace(parameterization, vertex, fans, landmarks);
    if (sweep % kSweepsPerCheck != 0) continue;
    const double after = stressOf(parameterization, fans, landmarks);
    if (!(after < (1.0 - kStressConverged) * before)) break;
    before = after;
  }
  return parameterization;
}

}  // namespace lamina
