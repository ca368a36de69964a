// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved_layers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lamina/slicing/facing_surface.hpp"
#include "lamina/surface/layer_volume.hpp"
#include "slicing/curved_division.hpp"
#include "slicing/curved_refusal.hpp"
#include "slicing/layer_coverage.hpp"
#include "slicing/part_samples.hpp"
#include "slicing/unreached_surface.hpp"

namespace lamina {
namespace {

// So many that 5 % of them are within 0.7 % of what they stand for.
constexpr std::size_t kSamples = 4000;
// What surely is out of reach of a surface's shells: so many layer heights and degrees beside its border.
constexpr double kBeside = 2.0;
constexpr double kSteepestDeg = 65.0;

struct ShellFamily {
  std::vector<LayerSurface> shells;
  std::vector<ShellEnd> ends;
};

ShellFamily propagate(const CurvedPart& part, const TriangleNumbers& source,
                      const std::optional<ShellBound>& bound, NozzleSide side, Progress& progress) {
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

CurvedLayers layersOf(const CurvedPart& part, const CurvedDivision& division, Progress& progress) {
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

/// The samples that a scheme cannot come to, whatever its layers look like.
std::vector<Point3> besideOf(const CurvedPart& part, const PartSamples& samples,
                             const CurvedDivision& division) {
  std::vector<Point3> below;
  std::vector<Point3> above;
  for (const Point3& point : samples.points()) {
    if (!division.lower_top_mm || point.z() < *division.lower_top_mm)
      below.push_back(point);
    else if (point.z() > division.upper_bottom_mm)
      above.push_back(point);
  }
  const auto outOfReach = [&](const std::vector<Point3>& points, const TriangleNumbers& patch) {
    if (points.empty() || patch.empty()) return points;
    return unreached(points, turnedOver(patchOf(part.mesh, patch)), kBeside * part.height_mm, kSteepestDeg);
  };
  std::vector<Point3> beside = outOfReach(below, division.lower);
  const std::vector<Point3> beside_upper = outOfReach(above, division.upper);
  beside.insert(beside.end(), beside_upper.begin(), beside_upper.end());
  return beside;
}

/// Counts the layers at every sample; what is wrong goes into the layers' shares.
CurvedFlaws checked(CurvedLayers& layers, const PartSamples& samples, Progress& progress) {
  CurvedFlaws flaws;
  flaws.scheme = layers.scheme;
  const std::vector<std::uint32_t> counts =
      layerCounts(samples, {layers.lower, layers.middle, layers.upper}, progress);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) flaws.open.push_back(samples.points()[i]);
    if (counts[i] > 1) flaws.twice.push_back(samples.points()[i]);
  }
  const double all = static_cast<double>(counts.size());
  layers.coverage = {counts.size(), static_cast<double>(flaws.open.size()) / all,
                     static_cast<double>(flaws.twice.size()) / all};
  return flaws;
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
  const CurvedPart part = curvedPart(mesh, topology, settings, layer_height_mm);
  const std::vector<CurvedDivision> ways = curvedDivisions(part);
  const PartSamples samples(mesh, kSamples);
  const double most = 0.01 * settings.largest_gap_percent * static_cast<double>(samples.points().size());
  std::optional<CurvedFlaws> least;
  for (const CurvedDivision& division : ways) {
    CurvedFlaws flaws;
    flaws.scheme = division.scheme;
    flaws.beside = besideOf(part, samples, division);
    if (static_cast<double>(flaws.count()) <= most) {
      CurvedLayers layers = layersOf(part, division, progress);
      flaws = checked(layers, samples, progress);
      if (static_cast<double>(flaws.count()) <= most) return layers;
    }
    if (!least || flaws.count() < least->count()) least = std::move(flaws);
  }
  refuseCurved(part, samples, *least);
}

}  // namespace lamina
