// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/curved_layers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/curved/layer_coverage.hpp"
#include "slicing/curved/part_samples.hpp"
#include "slicing/curved/shell_tidying.hpp"
#include "slicing/curved/unreached_surface.hpp"

namespace lamina {
namespace {

/// What all schemes of curved layers start from. The mesh, topology and settings must outlive it.
struct CurvedPart {
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
struct CurvedDivision {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::optional<double> lower_top_mm;  // nothing: lower shells go as high as the part
  double upper_bottom_mm = 0.0;
  TriangleNumbers lower;
  TriangleNumbers upper;
};

// Of the part's size: overlap of lower and upper surface in height that is rounding.
constexpr double kLevel = 1e-6;

/// The first patch and all others that come below (sign 1) or above (sign -1) a height.
TriangleNumbers sourceOf(const Mesh& mesh, const std::vector<TriangleNumbers>& patches, double sign,
                         double level) {
  TriangleNumbers source;
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (i == 0 || -greatestHeight(mesh, patches[i], -sign) < sign * level)
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

/// @throws Unsliceable if nothing faces down or up
/// @throws InvalidMesh if the mesh is open or holds no volume; InvalidConfig
CurvedPart curvedPart(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                      double layer_height_mm) {
  if (!(layer_height_mm > 0.0))
    throw InvalidConfig("slicing.layer_height_mm is " + numberText(layer_height_mm) +
                        " mm; must be positive");
  if (topology.has_border) throw InvalidMesh("the mesh is open; curved layers need a closed one");
  if (!(volume(mesh) > 0.0))
    throw InvalidMesh("the mesh holds " + numberText(volume(mesh)) + " mm³; expected a positive volume");
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
                          " by more than curved.normal_limit " + numberText(settings.normal_limit) +
                          "; curved layers have nothing to grow from",
                      mesh);
  return part;
}

/// The ways to divide a part, the one to be preferred first.
std::vector<CurvedDivision> curvedDivisions(const CurvedPart& part) {
  const double lower_top = greatestHeight(part.mesh, part.lower.front(), 1.0);
  const double upper_bottom = -greatestHeight(part.mesh, part.upper.front(), -1.0);
  const double middle = 0.5 * (lower_top + upper_bottom);
  if (lower_top <= upper_bottom) return {twoSides(part, CurvedScheme::BothSides, lower_top, upper_bottom)};
  if (lower_top <= upper_bottom + kLevel * part.size_mm)
    return {twoSides(part, CurvedScheme::BothSides, middle, middle)};
  return {lowerOnly(part), twoSides(part, CurvedScheme::Halves, middle, middle)};
}

/// What a scheme gets wrong, as samples of the part.
struct CurvedFlaws {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::vector<Point3> beside;  ///< beyond the edges of what its layers grow from, found before they grow
  std::vector<Point3> open;    ///< in no layer
  std::vector<Point3> twice;   ///< in more than one layer
  std::vector<Point3> hollow;  ///< of those that are open, the most that hang together

  /// As many samples as are wrong at least.
  std::size_t count() const { return std::max(beside.size(), open.size() + twice.size()); }
};

// Spacings of the samples: how far from one of them others count as of the same place.
constexpr double kSamePlace = 3.0;

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// The surface nearest to samples, and what of it is no farther from there than samples from each other.
Mesh surfaceNear(const CurvedPart& part, const std::vector<Point3>& points, double spacing_mm) {
  std::vector<char> is_nearest(part.mesh.triangles.size(), 0);
  for (const Point3& point : points) is_nearest[part.inside.surface().nearest(point).triangle] = 1;
  TriangleNumbers numbers;
  for (std::uint32_t i = 0; i < is_nearest.size(); ++i)
    if (is_nearest[i] != 0) numbers.push_back(i);
  const Mesh core = patchOf(part.mesh, numbers);
  const NearestTriangle nearest(core);
  for (std::uint32_t i = 0; i < is_nearest.size(); ++i) {
    const Triangle& corner = part.mesh.triangles[i];
    const Point3 middle =
        (part.mesh.vertices[corner[0]] + part.mesh.vertices[corner[1]] + part.mesh.vertices[corner[2]]) / 3.0;
    if (is_nearest[i] == 0 && nearest.nearest(middle, spacing_mm)) is_nearest[i] = 1;
  }
  numbers.clear();
  for (std::uint32_t i = 0; i < is_nearest.size(); ++i)
    if (is_nearest[i] != 0) numbers.push_back(i);
  return patchOf(part.mesh, numbers);
}

// Spacings of the samples: how far apart they are that hang together.
constexpr double kTogether = 1.25;
// Fewer samples that hang together may be chance.
constexpr std::size_t kLeastTogether = 4;

/// The most points of which each is near another one.
std::vector<Point3> hangingTogether(std::vector<Point3> points, double within_mm) {
  std::vector<Point3> most;
  while (points.size() > most.size()) {
    std::vector<Point3> group = {points.back()};
    points.pop_back();
    for (std::size_t i = 0; i < group.size(); ++i) {
      const auto isFar = [&](const Point3& point) { return (point - group[i]).norm() > within_mm; };
      const auto near = std::stable_partition(points.begin(), points.end(), isFar);
      group.insert(group.end(), near, points.end());
      points.erase(near, points.end());
    }
    if (group.size() > most.size()) most = std::move(group);
  }
  return most;
}

const char* surfacesOf(CurvedScheme scheme) {
  return scheme == CurvedScheme::LowerOnly ? "underside" : "underside and top side";
}

struct Complaint {
  const std::vector<Point3>& points;
  std::string reason;
};

Complaint complaintOn(const CurvedPart& part, const CurvedFlaws& flaws) {
  const std::string sides = surfacesOf(flaws.scheme);
  if (!flaws.beside.empty())
    return {flaws.beside, " of the part lies beside its " + sides +
                              ", beyond their edges, where layers that follow them do not come"};
  if (flaws.open.size() >= flaws.twice.size())
    return {flaws.open, " of the part would be left open, because layers that follow its " + sides +
                            " break up where these are rough or bend sharply for layers of " +
                            rounded(part.height_mm, 3) + " mm"};
  return {flaws.twice, " of the part would be deposited twice, because layers that grow from its " + sides +
                           " run into each other"};
}

/// Refuses a part for what the scheme that comes nearest gets wrong: what, where, and what to do instead. The
/// region is the surface nearest to it.
/// @throws Unsliceable always
[[noreturn]] void refuseFlaws(const CurvedPart& part, const PartSamples& samples, const CurvedFlaws& flaws) {
  const Complaint complaint = complaintOn(part, flaws);
  const double share =
      static_cast<double>(complaint.points.size()) / static_cast<double>(samples.points().size());
  const Point3 where = densestPlace(complaint.points, kSamePlace * samples.spacing());
  throw Unsliceable("curved layers do not suit this shape: " + rounded(100.0 * share, 1) + " %" +
                        complaint.reason + ", most of it around (" + rounded(where.x(), 1) + ", " +
                        rounded(where.y(), 1) + ", " + rounded(where.z(), 1) +
                        ") mm; open and double are at most " + rounded(part.settings.largest_gap_percent, 1) +
                        " % expected (curved.largest_gap_percent). Slice it with slicing.mode=planar or "
                        "heightfield, or turn it so that a smooth side without feet or pockets lies below.",
                    surfaceNear(part, complaint.points, samples.spacing()));
}

/// Refuses a part for one void in it.
/// @throws Unsliceable always
[[noreturn]] void refuseVoid(const CurvedPart& part, const PartSamples& samples, const CurvedFlaws& flaws,
                             double void_mm3) {
  const Point3 where = densestPlace(flaws.hollow, kSamePlace * samples.spacing());
  throw Unsliceable("curved layers do not suit this shape: a void of about " + rounded(void_mm3, 0) +
                        " mm3 would be left open around (" + rounded(where.x(), 1) + ", " +
                        rounded(where.y(), 1) + ", " + rounded(where.z(), 1) + ") mm; expected at most " +
                        rounded(part.settings.largest_void_mm3, 1) +
                        " mm3 (curved.largest_void_mm3). Slice it with slicing.mode=planar or heightfield, "
                        "or turn it so that a smooth side without feet or pockets lies below.",
                    surfaceNear(part, flaws.hollow, samples.spacing()));
}

// Part of a layer's height by which the level layers of [Guacheta2021, listing A.7] may lie in those below
// and above them.
constexpr double kLargestOverlap = 0.05;

constexpr double kAll = std::numeric_limits<double>::infinity();
// So many that 5 % of them are within 0.7 % of what they stand for.
constexpr std::size_t kSamples = 4000;
// What surely is out of reach of a surface's shells: so many layer heights and degrees beside its border.
constexpr double kBeside = 2.0;
constexpr double kSteepestDeg = 65.0;

// In squares of the layer height: the holes are those of a bead twice as wide as high.
constexpr double kLeastPiece = 0.1;
constexpr double kLargestHole = 4.0;

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
  std::vector<LayerSurface> shells = propagation.shells(part.height_mm, side, progress);
  const double square_mm2 = part.height_mm * part.height_mm;
  const TidyLimits too_small{kLeastPiece * square_mm2, kLargestHole * square_mm2};
  const auto tidy = [&](std::size_t i) { shells[i] = tidied(shells[i], too_small); };
  parallelFor(shells.size(), tidy, progress, "propagate shells");
  while (!shells.empty() && shells.back().middle.triangles.empty()) shells.pop_back();
  return {std::move(shells), propagation.ends(part.height_mm)};
}

ShellFamily lowerFamily(const CurvedPart& part, const CurvedDivision& division, Progress& progress) {
  std::optional<ShellBound> above;
  if (division.lower_top_mm) above = ShellBound{Point3::UnitZ(), *division.lower_top_mm};
  return propagate(part, division.lower, above, NozzleSide::Ahead, progress);
}

ShellFamily upperFamily(const CurvedPart& part, const CurvedDivision& division, Progress& progress) {
  const ShellBound below{-Point3::UnitZ(), -division.upper_bottom_mm};
  ShellFamily upper = propagate(part, division.upper, below, NozzleSide::Behind, progress);
  std::reverse(upper.shells.begin(), upper.shells.end());
  return upper;
}

std::vector<Layer> levelLayers(const CurvedPart& part, const CurvedDivision& division, Progress& progress) {
  if (!division.lower_top_mm) return {};
  const auto layer_bounds = middleBounds(*division.lower_top_mm, division.upper_bottom_mm, part.height_mm);
  std::vector<double> cuts;
  cuts.reserve(layer_bounds.size());
  for (const LayerBounds& bounds : layer_bounds) cuts.push_back(bounds.cut());
  std::vector<Section> sections = sliceMesh(part.mesh, part.topology, cuts, progress);
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < layer_bounds.size(); ++i)
    layers.push_back({layer_bounds[i], std::move(sections[i])});
  return layers;
}

LayerVolumes volumesOf(const CurvedPart& part, const CurvedLayers& layers) {
  LayerVolumes volumes{volume(part.mesh), volume(layers.lower), 0.0, volume(layers.upper)};
  for (const Layer& layer : layers.middle)
    volumes.middle_mm3 += signedArea(layer.section.contours) * layer.bounds.height();
  return volumes;
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

/// What is open or deposited twice below a height.
CurvedFlaws flawsBelow(double ceiling_mm, const CurvedLayers& layers, const PartSamples& samples,
                       Progress& progress) {
  CurvedFlaws flaws;
  flaws.scheme = layers.scheme;
  const std::vector<std::uint32_t> counts =
      layerCounts(samples, {layers.lower, layers.middle, layers.upper}, progress);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Point3& point = samples.points()[i];
    if (point.z() > ceiling_mm) continue;
    if (counts[i] == 0) flaws.open.push_back(point);
    if (counts[i] > 1) flaws.twice.push_back(point);
  }
  return flaws;
}

/// As many samples as may be wrong.
std::size_t mostFlaws(const CurvedPart& part, const PartSamples& samples) {
  return static_cast<std::size_t>(0.01 * part.settings.largest_gap_percent *
                                  static_cast<double>(samples.points().size()));
}

/// A scheme's layers and what is wrong with them. If that is too much, layers may be missing.
struct Attempt {
  CurvedLayers layers;
  CurvedFlaws flaws;
};

Attempt attempted(const CurvedPart& part, const CurvedDivision& division, const PartSamples& samples,
                  Progress& progress) {
  const std::size_t most = mostFlaws(part, samples);
  Attempt attempt;
  auto& [layers, flaws] = attempt;
  layers.scheme = division.scheme;
  flaws.scheme = division.scheme;
  flaws.beside = besideOf(part, samples, division);
  if (flaws.count() > most) return attempt;
  ShellFamily lower = lowerFamily(part, division, progress);
  layers.lower = std::move(lower.shells);
  layers.lower_ends = std::move(lower.ends);
  if (!division.upper.empty()) {
    const double ceiling = division.lower_top_mm.value_or(kAll) - part.height_mm;
    flaws = flawsBelow(ceiling, layers, samples, progress);
    if (flaws.count() > most) return attempt;
  }
  ShellFamily upper = upperFamily(part, division, progress);
  layers.upper = std::move(upper.shells);
  layers.upper_ends = std::move(upper.ends);
  layers.middle = levelLayers(part, division, progress);
  layers.volumes = volumesOf(part, layers);
  flaws = flawsBelow(kAll, layers, samples, progress);
  const auto share = [&](const std::vector<Point3>& points) {
    return static_cast<double>(points.size()) / static_cast<double>(samples.points().size());
  };
  flaws.hollow = hangingTogether(flaws.open, kTogether * samples.spacing());
  if (flaws.hollow.size() < kLeastTogether) flaws.hollow.clear();
  layers.coverage = {samples.points().size(), share(flaws.open), share(flaws.twice),
                     share(flaws.hollow) * layers.volumes.part_mm3};
  return attempt;
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

namespace {

std::vector<LayerBounds> boundsOf(double bottom_mm, double height_mm, double count) {
  std::vector<LayerBounds> layer_bounds;
  for (double i = 0.0; i < count; ++i)
    layer_bounds.push_back({bottom_mm + i * height_mm, bottom_mm + (i + 1.0) * height_mm});
  return layer_bounds;
}

}  // namespace

std::vector<LayerBounds> middleBounds(double low_mm, double high_mm, double layer_height_mm) {
  const double room = high_mm - low_mm;
  if (room < 0.5 * layer_height_mm) return {};
  if (room < 1.5 * layer_height_mm) return {{low_mm, high_mm}};
  const double of_source = std::max(2.0, std::floor((room - layer_height_mm) / layer_height_mm + 1.01));
  const double step = (room - layer_height_mm) / (of_source - 1.0);
  if (std::abs(step - layer_height_mm) <= kLargestOverlap * layer_height_mm)
    return boundsOf(low_mm + 0.5 * (layer_height_mm - step), step, of_source);
  const double count = std::round(room / layer_height_mm);
  return boundsOf(low_mm, room / count, count);
}

CurvedLayers curvedLayers(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                          double layer_height_mm, Progress& progress) {
  const CurvedPart part = curvedPart(mesh, topology, settings, layer_height_mm);
  const std::vector<CurvedDivision> ways = curvedDivisions(part);
  const PartSamples samples(mesh, kSamples);
  const std::size_t most = mostFlaws(part, samples);
  std::optional<CurvedFlaws> least;
  double void_mm3 = 0.0;
  for (const CurvedDivision& division : ways) {
    Attempt attempt = attempted(part, division, samples, progress);
    CurvedFlaws& flaws = attempt.flaws;
    const double hollow_mm3 = attempt.layers.coverage.void_mm3;
    if (flaws.count() <= most && hollow_mm3 <= settings.largest_void_mm3) return std::move(attempt.layers);
    if (least && flaws.count() >= least->count()) continue;
    least = std::move(flaws);
    void_mm3 = hollow_mm3;
  }
  if (least->count() > most) refuseFlaws(part, samples, *least);
  refuseVoid(part, samples, *least, void_mm3);
}

}  // namespace lamina
