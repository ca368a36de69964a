// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved_layers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lamina/base/error.hpp"
#include "lamina/slicing/facing_surface.hpp"
#include "lamina/surface/layer_volume.hpp"
#include "slicing/unreached_surface.hpp"

namespace lamina {
namespace {

// Of the part's size: overlap of lower and upper surface in height that is rounding.
constexpr double kLevel = 1e-6;

/// What all schemes start from.
struct Part {
  const Mesh& mesh;
  const MeshTopology& topology;
  const CurvedSettings& settings;
  double height_mm;
  SignedDistance inside;
  std::vector<TriangleNumbers> lower;
  std::vector<TriangleNumbers> upper;
  double size_mm;
};

/// A scheme, its division of the part in height, and the surfaces its shells come from.
struct Division {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::optional<double> lower_top_mm;  // nothing: lower shells go as high as the part
  double upper_bottom_mm = 0.0;
  TriangleNumbers lower;
  TriangleNumbers upper;
};

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

Division twoSides(const Part& part, CurvedScheme scheme, double lower_top, double upper_bottom) {
  return {scheme, lower_top, upper_bottom, sourceOf(part.mesh, part.lower, 1.0, lower_top),
          sourceOf(part.mesh, part.upper, -1.0, upper_bottom)};
}

Division lowerOnly(const Part& part) {
  return {CurvedScheme::LowerOnly,
          std::nullopt,
          0.0,
          sourceOf(part.mesh, part.lower, 1.0, std::numeric_limits<double>::infinity()),
          {}};
}

/// The ways to divide a part, the one to be preferred first.
std::vector<Division> divisions(const Part& part) {
  const double lower_top = highest(part.mesh, part.lower.front(), 1.0);
  const double upper_bottom = -highest(part.mesh, part.upper.front(), -1.0);
  const double middle = 0.5 * (lower_top + upper_bottom);
  if (lower_top <= upper_bottom) return {twoSides(part, CurvedScheme::BothSides, lower_top, upper_bottom)};
  if (lower_top <= upper_bottom + kLevel * part.size_mm)
    return {twoSides(part, CurvedScheme::BothSides, middle, middle)};
  return {lowerOnly(part), twoSides(part, CurvedScheme::Halves, middle, middle)};
}

struct ShellFamily {
  std::vector<LayerSurface> shells;
  std::vector<ShellEnd> ends;
};

ShellFamily propagate(const Part& part, const TriangleNumbers& source, const std::optional<ShellBound>& bound,
                      NozzleSide side, Progress& progress) {
  if (source.empty()) return {};
  ShellSource inward = shellSourceOf(part.mesh, source);
  inward.surface = turnedOver(std::move(inward.surface));
  const Mesh rest = patchOf(part.mesh, remainder(part.mesh, source, {}));
  const NearestTriangle nearest_rest(rest);
  const ShellLimits limits{&part.inside, PartSide::Inside, &nearest_rest,
                           bound,        part.size_mm,     part.height_mm};
  const ShellPropagation propagation(inward, part.settings.longest_edge_mm, limits, progress);
  return {propagation.shells(part.height_mm, side, progress), propagation.ends(part.height_mm)};
}

CurvedLayers layersOf(const Part& part, const Division& division, Progress& progress) {
  CurvedLayers layers;
  layers.scheme = division.scheme;
  std::optional<ShellBound> above;
  if (division.lower_top_mm) above = ShellBound{Point3::UnitZ(), *division.lower_top_mm};
  ShellFamily lower = propagate(part, division.lower, above, NozzleSide::Ahead, progress);
  const ShellBound below{-Point3::UnitZ(), -division.upper_bottom_mm};
  ShellFamily upper = propagate(part, division.upper, below, NozzleSide::Behind, progress);
  std::reverse(upper.shells.begin(), upper.shells.end());
  layers.volumes = {volume(part.mesh), volume(lower.shells), 0.0, volume(upper.shells)};
  layers.lower = std::move(lower.shells);
  layers.lower_ends = std::move(lower.ends);
  layers.upper = std::move(upper.shells);
  layers.upper_ends = std::move(upper.ends);
  if (!division.lower_top_mm) return layers;
  const auto slabs = middleSlabs(*division.lower_top_mm, division.upper_bottom_mm, part.height_mm);
  std::vector<double> cuts;
  cuts.reserve(slabs.size());
  for (const LayerSlab& slab : slabs) cuts.push_back(slab.cut());
  std::vector<Section> sections = sliceMesh(part.mesh, part.topology, cuts, progress);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    layers.volumes.middle_mm3 += signedArea(sections[i].contours) * slabs[i].height();
    layers.middle.push_back({slabs[i], std::move(sections[i])});
  }
  return layers;
}

TriangleNumbers between(const Mesh& mesh, double low, double high) {
  TriangleNumbers numbers;
  for (std::uint32_t number = 0; number < mesh.triangles.size(); ++number) {
    const Triangle& corner = mesh.triangles[number];
    const double z =
        (mesh.vertices[corner[0]].z() + mesh.vertices[corner[1]].z() + mesh.vertices[corner[2]].z()) / 3.0;
    if (z >= low && z <= high) numbers.push_back(number);
  }
  return numbers;
}

TriangleNumbers unreachedBy(const Part& part, const Division& division) {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  const double reach = 2.0 * part.height_mm;
  const Mesh lower = turnedOver(patchOf(part.mesh, division.lower));
  TriangleNumbers region =
      unreached(part.mesh, between(part.mesh, -kAll, division.lower_top_mm.value_or(kAll)), lower, reach);
  if (division.upper.empty()) return region;
  const Mesh upper = turnedOver(patchOf(part.mesh, division.upper));
  const TriangleNumbers above =
      unreached(part.mesh, between(part.mesh, division.upper_bottom_mm, kAll), upper, reach);
  region.insert(region.end(), above.begin(), above.end());
  std::sort(region.begin(), region.end());
  region.erase(std::unique(region.begin(), region.end()), region.end());
  return region;
}

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

[[noreturn]] void refuse(const Part& part, const Division& division, const CurvedLayers& layers) {
  Mesh region = patchOf(part.mesh, unreachedBy(part, division));
  const double gap = layers.volumes.gap();
  std::string message = "curved layers (" + std::string(toString(division.scheme)) + ") would " +
                        (gap > 0.0 ? "leave open " : "lay twice ") + rounded(100.0 * std::abs(gap), 1) +
                        " % of the part's " + rounded(layers.volumes.part_mm3, 1) +
                        " mm³; expected at most " + rounded(part.settings.largest_gap_percent, 1) +
                        " % (curved.largest_gap_percent). ";
  if (region.triangles.empty()) {
    message += "Its lower and upper surfaces are too narrow or too rough for layers of " +
               rounded(part.height_mm, 3) + " mm.";
  } else {
    const Point3 centre = boundingBox(region).centre();
    message += rounded(surfaceArea(region), 1) + " mm² of its surface around (" + rounded(centre.x(), 1) +
               ", " + rounded(centre.y(), 1) + ", " + rounded(centre.z(), 1) +
               ") mm lie beyond the edges of the surfaces that layers grow from.";
  }
  throw Unsliceable(message + " Slice it planar, or turn it.", std::move(region));
}

Part partOf(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
            double layer_height_mm) {
  if (!(layer_height_mm > 0.0))
    throw InvalidConfig("slicing.layer_height_mm is " + std::to_string(layer_height_mm) +
                        " mm; must be positive");
  if (topology.has_border) throw InvalidMesh("the mesh is open; curved layers need a closed one");
  if (!(volume(mesh) > 0.0))
    throw InvalidMesh("the mesh holds " + std::to_string(volume(mesh)) + " mm³; expected a positive volume");
  Part part{mesh,
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

}  // namespace

const char* toString(CurvedScheme scheme) {
  switch (scheme) {
    case CurvedScheme::Halves:
      return "halves";
    case CurvedScheme::LowerOnly:
      return "lower only";
    default:
      return "both sides";
  }
}

std::vector<LayerSlab> middleSlabs(double low_mm, double high_mm, double layer_height_mm) {
  const double room = high_mm - low_mm;
  if (room < 0.5 * layer_height_mm) return {};
  if (room < 1.5 * layer_height_mm) return {{low_mm, high_mm}};
  const double count = std::max(2.0, std::floor((room - layer_height_mm) / layer_height_mm + 1.01));
  const double step = (room - layer_height_mm) / (count - 1.0);
  std::vector<LayerSlab> slabs;
  for (double i = 0.0; i < count; ++i) {
    const double cut = low_mm + 0.5 * layer_height_mm + i * step;
    slabs.push_back({cut - 0.5 * step, cut + 0.5 * step});
  }
  return slabs;
}

CurvedLayers curvedLayers(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                          double layer_height_mm, Progress& progress) {
  const Part part = partOf(mesh, topology, settings, layer_height_mm);
  const std::vector<Division> ways = divisions(part);
  CurvedLayers layers;
  for (const Division& division : ways) {
    layers = layersOf(part, division, progress);
    if (100.0 * std::abs(layers.volumes.gap()) <= settings.largest_gap_percent) return layers;
  }
  refuse(part, ways.back(), layers);
}

}  // namespace lamina
