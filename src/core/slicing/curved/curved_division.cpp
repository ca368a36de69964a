// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/curved_division.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

// Of the part's size: overlap of lower and upper surface in height that is rounding.
constexpr double kLevel = 1e-6;

double highest(const Mesh& mesh, const TriangleNumbers& patch, double sign) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t number : patch)
    for (const std::uint32_t corner : mesh.triangles[number])
      highest = std::max(highest, sign * mesh.vertices[corner].z());
  return highest;
}

/// The first patch and all others that come below (sign 1) or above (sign -1) a height.
TriangleNumbers sourceOf(const Mesh& mesh, const std::vector<TriangleNumbers>& patches, double sign,
                         double level) {
  TriangleNumbers source;
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (i == 0 || -highest(mesh, patches[i], -sign) < sign * level)
      source.insert(source.end(), patches[i].begin(), patches[i].end());
  std::sort(source.begin(), source.end());
  return source;
}

CurvedDivision twoSides(const CurvedPart& part, CurvedScheme scheme, double lower_top, double upper_bottom) {
  return {scheme, lower_top, upper_bottom, sourceOf(part.mesh, part.lower, 1.0, lower_top),
          sourceOf(part.mesh, part.upper, -1.0, upper_bottom)};
}

CurvedDivision lowerOnly(const CurvedPart& part) {
  return {CurvedScheme::LowerOnly,
          std::nullopt,
          0.0,
          sourceOf(part.mesh, part.lower, 1.0, std::numeric_limits<double>::infinity()),
          {}};
}

}  // namespace

CurvedPart curvedPart(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                      double layer_height_mm) {
  if (!(layer_height_mm > 0.0))
    throw InvalidConfig("slicing.layer_height_mm is " + std::to_string(layer_height_mm) +
                        " mm; must be positive");
  if (topology.has_border) throw InvalidMesh("the mesh is open; curved layers need a closed one");
  if (!(volume(mesh) > 0.0))
    throw InvalidMesh("the mesh holds " + std::to_string(volume(mesh)) + " mm³; expected a positive volume");
  CurvedPart part{mesh,
                  topology,
                  settings,
                  layer_height_mm,
                  SignedDistance(mesh),
                  facingPatches(mesh, Facing::Down, settings.normal_limit),
                  facingPatches(mesh, Facing::Up, settings.normal_limit),
                  boundingBox(mesh).size().norm()};
  if (part.lower.empty() || part.upper.empty())
    throw Unsliceable("no surface faces " + std::string(part.lower.empty() ? "down" : "up") +
                          " by more than curved.normal_limit " + std::to_string(settings.normal_limit) +
                          "; curved layers have nothing to grow from",
                      mesh);
  return part;
}

std::vector<CurvedDivision> curvedDivisions(const CurvedPart& part) {
  const double lower_top = highest(part.mesh, part.lower.front(), 1.0);
  const double upper_bottom = -highest(part.mesh, part.upper.front(), -1.0);
  const double middle = 0.5 * (lower_top + upper_bottom);
  if (lower_top <= upper_bottom) return {twoSides(part, CurvedScheme::BothSides, lower_top, upper_bottom)};
  if (lower_top <= upper_bottom + kLevel * part.size_mm)
    return {twoSides(part, CurvedScheme::BothSides, middle, middle)};
  return {lowerOnly(part), twoSides(part, CurvedScheme::Halves, middle, middle)};
}

}  // namespace lamina
