// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "revolve.hpp"

#include <cmath>

namespace lamina {
namespace {

/// The vertices that one point of the outline sweeps: a ring, or one vertex on the axis.
struct Swept {
  std::uint32_t first;
  bool is_on_axis;

  std::uint32_t at(std::uint32_t segment) const { return is_on_axis ? first : first + segment; }
};

Swept sweep(Mesh& mesh, const Point2& point, int segments) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  if (point.x() == 0.0) {
    mesh.vertices.emplace_back(0.0, 0.0, point.y());
    return {first, true};
  }
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * M_PI * i / segments;
    mesh.vertices.emplace_back(point.x() * std::cos(angle), point.x() * std::sin(angle), point.y());
  }
  return {first, false};
}

void addTurnedBand(Mesh& mesh, const Swept& from, const Swept& to, int segments) {
  const auto count = static_cast<std::uint32_t>(segments);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    if (!from.is_on_axis) mesh.triangles.push_back({from.at(i), from.at(j), to.at(j)});
    if (!to.is_on_axis) mesh.triangles.push_back({from.at(i), to.at(j), to.at(i)});
  }
}

}  // namespace

Mesh revolve(const Polygon& outline, int segments) {
  Mesh mesh;
  std::vector<Swept> swept;
  for (const Point2& point : outline) swept.push_back(sweep(mesh, point, segments));
  for (std::size_t i = 0; i < swept.size(); ++i) {
    const Swept& from = swept[i];
    const Swept& to = swept[(i + 1) % swept.size()];
    if (!(from.is_on_axis && to.is_on_axis)) addTurnedBand(mesh, from, to, segments);
  }
  return mesh;
}

}  // namespace lamina
