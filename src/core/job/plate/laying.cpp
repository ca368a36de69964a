// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/plate/laying.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/hull_faces.hpp"

namespace lamina {
namespace {

constexpr double kSameCost = 1e-6;
constexpr double kSameLean = 1e-6;  // of the cosine

/// Turns about x, then y, that bring a direction straight down.
Point3 turnDown(const Point3& direction) {
  const double across = direction.tail<2>().norm();
  const double about_x = across > 1e-12 ? -0.5 * M_PI - std::atan2(direction.z(), direction.y()) : 0.0;
  const double about_y = std::atan2(direction.x(), across);
  const auto degrees = [](double angle) {
    const double turned = std::remainder(toDegrees(angle), 360.0);
    if (std::abs(turned) < 1e-9) return 0.0;
    return turned <= -180.0 + 1e-9 ? 180.0 : turned;
  };
  return {degrees(about_x), degrees(about_y), 0.0};
}

Laying layingOn(const HullFace& face, const Mesh& part, const LayingSettings& settings) {
  Laying laying;
  laying.turn_deg = turnDown(face.normal);
  laying.face_mm2 = face.area_mm2;
  const Point3 up = -face.normal;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const Point3& vertex : part.vertices) {
    lowest = std::min(lowest, up.dot(vertex));
    highest = std::max(highest, up.dot(vertex));
  }
  laying.height_mm = highest - lowest;
  const double hangs_from = std::sin(toRadians(settings.overhang_deg)) + kSameLean;
  for (const Triangle& corners : part.triangles) {
    const Point3& a = part.vertices[corners[0]];
    const Point3& b = part.vertices[corners[1]];
    const Point3& c = part.vertices[corners[2]];
    const Point3 doubled = (b - a).cross(c - a);
    const double down = -up.dot(doubled);
    if (down <= hangs_from * doubled.norm()) continue;
    if (std::max({up.dot(a), up.dot(b), up.dot(c)}) - lowest <= settings.on_bed_mm) continue;
    laying.overhang_mm2 += 0.5 * down;
  }
  return laying;
}

bool isBetter(const Laying& a, const Laying& b) {
  if (std::abs(a.cost() - b.cost()) > kSameCost) return a.cost() < b.cost();
  if (std::abs(a.face_mm2 - b.face_mm2) > kSameCost) return a.face_mm2 > b.face_mm2;
  return a.turn_deg.norm() < b.turn_deg.norm();
}

}  // namespace

std::vector<Laying> layings(const Mesh& part, const LayingSettings& settings) {
  std::vector<HullFace> faces = hullFaces(part.vertices);
  if (faces.empty()) throw InvalidMesh("the part is flat; expected one with a volume, which has a hull");
  if (faces.size() > settings.most_faces) faces.resize(settings.most_faces);
  std::vector<Laying> found(faces.size());
  NoProgress nobody;
  parallelFor(
      faces.size(), [&](std::size_t i) { found[i] = layingOn(faces[i], part, settings); }, nobody, "lay");
  std::stable_sort(found.begin(), found.end(), isBetter);
  return found;
}

}  // namespace lamina
