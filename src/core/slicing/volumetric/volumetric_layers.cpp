// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/volumetric_layers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "slicing/adapted/mesh_region.hpp"
#include "slicing/curved/layer_coverage.hpp"
#include "slicing/curved/part_samples.hpp"
#include "slicing/curved/shell_tidying.hpp"
#include "slicing/volumetric/grown_part.hpp"
#include "slicing/volumetric/growth_surfaces.hpp"

namespace lamina {
namespace {

constexpr double kLeastResting = 0.5;
constexpr double kCarriedBeads = 4.0;  // squares of a bead that may hang from the rest of a piece
// So many that 0.5 % of them are within 0.1 % of what they stand for.
constexpr std::size_t kSamplesOfPart = 20000;
constexpr double kNearTogether = 3.0;  // spacings of samples

void requireClosed(const Mesh& mesh, const MeshTopology& topology) {
  if (topology.has_border) throw InvalidMesh("the mesh is open; volumetric layers need a closed one");
  const double inside = volume(mesh);
  if (!(inside > 0.0))
    throw InvalidMesh("the mesh holds " + numberText(inside) + " mm³; expected a positive volume");
}

std::string placeText(const Point3& place) {
  char text[100];
  std::snprintf(text, sizeof text, "(%.1f, %.1f, %.1f) mm", place.x(), place.y(), place.z());
  return text;
}

Mesh trianglesWhere(const Mesh& mesh, const std::vector<double>& weight) {
  TriangleNumbers numbers;
  for (std::uint32_t i = 0; i < weight.size(); ++i)
    if (weight[i] > 0.0) numbers.push_back(i);
  return patchOf(mesh, numbers);
}

void requireReached(const GrownPart& part, const Pendant& pendant, const HangingSurface& hanging) {
  const double percent = pendant.percent();
  if (percent <= part.request.settings.largest_pendant_percent) return;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "%.3g mm³ of the part, %.2f %%, hang lower than growth comes to, the lowest at %s; expected at most "
      "%.4g %% (volumetric.largest_pendant_percent): turn the part, or let layers tilt more "
      "(volumetric.max_tilt_deg)",
      pendant.volume_mm3, percent, placeText(pendant.lowest).c_str(),
      part.request.settings.largest_pendant_percent);
  throw Unsliceable(text, trianglesWhere(part.mesh, hanging.grown_by_triangle));
}

Point3 middleOfMost(const Mesh& mesh, const std::vector<double>& weight) {
  const auto most = static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
  const Triangle& corner = mesh.triangles[most];
  return (mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]) / 3.0;
}

void requireSupported(const GrownPart& part, const HangingSurface& hanging) {
  const double percent = 100.0 * hanging.grown_mm2 / hanging.surface_mm2;
  const VolumetricSettings& settings = part.request.settings;
  if (percent <= settings.largest_unsupported_percent) return;
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%.4g mm² of the surface, %.2f %%, overhang by more than %.4g deg from volumetric layers (%.2f %% from "
      "level ones), most of it at %s; expected at most %.4g %% (volumetric.largest_unsupported_percent): "
      "use smaller cells (volumetric.cell_mm) or less overhang (volumetric.overhang_used_deg), or turn it",
      hanging.grown_mm2, percent, settings.max_overhang_deg, 100.0 * hanging.level_mm2 / hanging.surface_mm2,
      placeText(middleOfMost(part.mesh, hanging.grown_by_triangle)).c_str(),
      settings.largest_unsupported_percent);
  throw Unsliceable(text, trianglesWhere(part.mesh, hanging.grown_by_triangle));
}

/// The faces about a place in the part: the nearest, and what is not much farther.
Mesh facesAbout(const Mesh& mesh, const Point3& place, double around_mm) {
  return facesNear(mesh, place, NearestTriangle(mesh).nearest(place).distance_mm + around_mm);
}

void requireEven(const GrownPart& part, const GrownThickness& thickness) {
  const VolumetricSettings& settings = part.request.settings;
  const double percent = 100.0 * thickness.beyond;
  if (percent <= settings.largest_uneven_percent) return;
  const double height_mm = part.request.slicing.layer_height_mm;
  char text[400];
  std::snprintf(text, sizeof text,
                "layers would be %.3f to %.3f mm thick, and outside %.3f to %.3f mm in %.2f %% of the part, "
                "farthest at "
                "%s; expected at most %.4g %% (volumetric.largest_uneven_percent): use smaller cells "
                "(volumetric.cell_mm), allow thicker layers (volumetric.max_thickness), or turn the part",
                thickness.least * height_mm, thickness.greatest * height_mm, height_mm,
                settings.max_thickness * height_mm, percent, placeText(thickness.farthest).c_str(),
                settings.largest_uneven_percent);
  throw Unsliceable(text, facesAbout(part.mesh, thickness.farthest, 2.0 * part.cells().frame().voxel_mm));
}

/// Of growth from up [rad], below which 99.5 % of the volume stay.
double usualTilt(const GrownPart& part) {
  std::vector<std::pair<double, double>> tilts;  // with the volume
  double whole = 0.0;
  for (std::uint32_t node = 0; node < part.cells().nodeCount(); ++node) {
    if (!std::isfinite(part.field().growth_mm[node])) continue;
    const Point3& middle = part.cells().middle(node);
    const Point3 gradient = part.field().near(middle, node, middle, part.gauge).gradient;
    tilts.emplace_back(std::atan2(gradient.head<2>().norm(), gradient.z()), part.cells().volume(node));
    whole += tilts.back().second;
  }
  std::sort(tilts.begin(), tilts.end());
  double above = 0.0;
  while (!tilts.empty() && above + tilts.back().second <= 0.005 * whole) {
    above += tilts.back().second;
    tilts.pop_back();
  }
  return tilts.empty() ? 0.0 : tilts.back().first;
}

void measureField(const GrownPart& part, VolumetricMeasures& measures) {
  const VolumetricRequest& request = part.request;
  const GrowthLattice& lattice = *part.lattice;
  measures.cell_mm = part.cells().frame().voxel_mm;
  measures.nodes = part.cells().nodeCount();
  measures.fitted = part.fitted;
  measures.fit_loss = part.fit_loss;
  measures.overhang_used_deg = toDegrees(part.overhang_rad);
  measures.contact_mm2 = part.field().contact_mm2;
  const Pendant pendant = pendantOf(part);
  measures.pendant_mm3 = pendant.volume_mm3;
  measures.volume_mm3 = pendant.whole_mm3;
  measures.tilt_deg = toDegrees(usualTilt(part));
  const GrownThickness thickness = grownThickness(part.cells(), lattice, request.settings.max_thickness);
  measures.thinnest = thickness.least;
  measures.thickest = thickness.greatest;
  measures.beyond_thickness = thickness.beyond;
  measures.minima = growthMinima(part.cells(), lattice, part.bed_mm);
  const HangingSurface& hanging = part.hanging;
  measures.surface_mm2 = hanging.surface_mm2;
  measures.unsupported_level_mm2 = hanging.level_mm2;
  measures.unsupported_mm2 = hanging.grown_mm2;
  requireReached(part, pendant, hanging);
  requireSupported(part, hanging);
  requireEven(part, thickness);
}

/// Layers by the growth at which they begin and end.
std::vector<LayerBounds> growthBounds(const GrownPart& part) {
  double most = 0.0;
  for (const double growth : part.field().growth_mm)
    if (std::isfinite(growth)) most = std::max(most, growth);
  return stackLayers(0.0, most + part.cells().frame().voxel_mm, part.request.slicing);
}

void cutLevelLayers(const GrownPart& part, const MeshTopology& topology, const std::vector<char>& is_level,
                    std::vector<VolumetricLayer>& layers, Progress& progress) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (is_level[i] != 0) heights.push_back(layers[i].plane.bounds.cut());
  std::vector<Section> sections = sliceMesh(part.mesh, topology, heights, progress);
  std::size_t next = 0;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (is_level[i] != 0) layers[i].plane.section = std::move(sections[next++]);
}

/// Pieces smaller than a bead's square have no room for a bead.
/// @return what they would have held [mm³]
double leaveOutCrumbs(std::vector<LayerSurface>& surfaces, double bead_mm, Progress& progress) {
  const double before = volume(surfaces);
  parallelFor(
      surfaces.size(),
      [&](std::size_t i) {
        if (!surfaces[i].middle.triangles.empty())
          surfaces[i] = tidied(surfaces[i], {bead_mm * bead_mm, 0.0});
      },
      progress, "layers");
  return before - volume(surfaces);
}

void requireResting(const std::vector<RestingShare>& shares, const std::vector<LayerSurface>& surfaces,
                    VolumetricMeasures& measures) {
  double area = 0.0;
  double resting = 0.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    area += shares[i].area_mm2;
    resting += shares[i].resting_mm2;
    measures.pieces += shares[i].pieces;
    if (shares[i].least < shares[worst].least) worst = i;
  }
  if (area <= 0.0) return;
  measures.resting = resting / area;
  measures.least_resting = shares[worst].least;
  if (measures.least_resting >= kLeastResting) return;
  char text[240];
  std::snprintf(text, sizeof text,
                "a piece of layer %zu at %s rests on what is deposited before it by %.0f %% of its area; "
                "expected at least %.0f %%: use smaller cells (volumetric.cell_mm), or turn the part",
                worst, placeText(shares[worst].least_at).c_str(), 100.0 * shares[worst].least,
                100.0 * kLeastResting);
  throw Unsliceable(text, surfaces[worst].middle);
}

void measureResting(const GrownPart& part, const std::vector<LayerSurface>& surfaces,
                    VolumetricMeasures& measures, Progress& progress) {
  const double carried_mm2 = kCarriedBeads * part.request.bead_mm * part.request.bead_mm;
  std::vector<RestingShare> shares(surfaces.size());
  parallelFor(
      surfaces.size(),
      [&](std::size_t i) { shares[i] = restingShare(surfaces[i], part.cells(), part.bed_mm, carried_mm2); },
      progress, "measure");
  requireResting(shares, surfaces, measures);
}

/// How often layers cover the samples above the bed, in shares of these.
struct CoverageShares {
  double open = 0.0;
  double twice = 0.0;
  std::vector<Point3> wrong;  ///< samples in no layer or in several, also of pendants
};

CoverageShares sharesAbove(double bed_mm, const PartSamples& samples,
                           const std::vector<std::uint32_t>& counts) {
  std::size_t above = 0;
  std::size_t open = 0;
  std::size_t twice = 0;
  std::vector<Point3> wrong;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (samples.points()[i].z() < bed_mm) continue;
    ++above;
    if (counts[i] == 0) ++open;
    if (counts[i] > 1) ++twice;
    if (counts[i] != 1) wrong.push_back(samples.points()[i]);
  }
  if (above == 0) return {};
  const auto whole = static_cast<double>(above);
  return {static_cast<double>(open) / whole, static_cast<double>(twice) / whole, std::move(wrong)};
}

/// Layers as they are cut: level ones by their sections, others by their surfaces.
struct CutLayers {
  const std::vector<VolumetricLayer>& layers;
  const std::vector<LayerSurface>& surfaces;
};

/// The layers of `planar` over the same bed.
std::vector<Layer> levelLayersOf(const GrownPart& part, const MeshTopology& topology, Progress& progress) {
  const std::vector<LayerBounds> bounds =
      stackLayers(part.bed_mm, boundingBox(part.mesh).high.z(), part.request.slicing);
  std::vector<double> heights;
  heights.reserve(bounds.size());
  for (const LayerBounds& layer : bounds) heights.push_back(layer.cut());
  std::vector<Section> sections = sliceMesh(part.mesh, topology, heights, progress);
  std::vector<Layer> layers;
  layers.reserve(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) layers.push_back({bounds[i], std::move(sections[i])});
  return layers;
}

/// What is in none of level layers, which end in steps at the skin as these do.
double openOfLevelLayers(const GrownPart& part, const MeshTopology& topology, Progress& progress) {
  const PartSamples samples(part.mesh, kSamplesOfPart);
  const std::vector<Layer> layers = levelLayersOf(part, topology, progress);
  return sharesAbove(part.bed_mm, samples, layerCounts(samples, {{}, layers, {}}, progress)).open;
}

/// Of places, those to which growth comes; all if it comes to none.
std::vector<Point3> reachedOf(const std::vector<Point3>& places, const GrownPart& part) {
  std::vector<Point3> reached;
  std::copy_if(places.begin(), places.end(), std::back_inserter(reached),
               [&](const Point3& place) { return std::isfinite(part.grown->at(place)); });
  return reached.empty() ? places : reached;
}

std::string levelAndPendantText(double open_level, double pendant) {
  char text[120];
  std::snprintf(text, sizeof text, "%.2f %% in none of level layers", 100.0 * open_level);
  if (pendant == 0.0) return text;
  char further[80];
  std::snprintf(further, sizeof further, ", %.2f %% hang where no layer leads", 100.0 * pendant);
  return std::string(text) + further;
}

/// Pendants have a limit of their own.
void requireCovered(const GrownPart& part, const CoverageShares& shares, const VolumetricMeasures& measures,
                    const PartSamples& samples) {
  const double pendant = measures.pendant_mm3 / measures.volume_mm3;
  const double percent = 100.0 * (std::max(0.0, shares.open - measures.open_level - pendant) + shares.twice);
  const double most = part.request.settings.largest_uncovered_percent;
  if (percent <= most || shares.wrong.empty()) return;
  const std::vector<Point3> wrong = reachedOf(shares.wrong, part);
  const double around_mm = kNearTogether * samples.spacing();
  const Point3 where = densestPlace(wrong, around_mm);
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%.2f %% of the part would be in no layer (%s) and %.2f %% in more "
      "than one, most of it around %s; expected at most %.4g %% beyond level layers%s "
      "(volumetric.largest_uncovered_percent): use smaller cells (volumetric.cell_mm), thinner layers, "
      "or turn the part",
      100.0 * shares.open, levelAndPendantText(measures.open_level, pendant).c_str(), 100.0 * shares.twice,
      placeText(where).c_str(), most, pendant > 0.0 ? " and what hangs where no layer leads" : "");
  throw Unsliceable(text, facesAbout(part.mesh, where, around_mm));
}

/// What is in no layer and in more than one, above the bed.
void measureCoverage(const GrownPart& part, const MeshTopology& topology, const CutLayers& cut,
                     VolumetricMeasures& measures, Progress& progress) {
  std::vector<Layer> level;
  for (const VolumetricLayer& layer : cut.layers)
    if (!layer.plane.section.contours.empty()) level.push_back(layer.plane);
  const PartSamples samples(part.mesh, kSamplesOfPart);
  const CoverageShares shares =
      sharesAbove(part.bed_mm, samples, layerCounts(samples, {cut.surfaces, level, {}}, progress));
  measures.open = shares.open;
  measures.twice = shares.twice;
  measures.open_level = openOfLevelLayers(part, topology, progress);
  requireCovered(part, shares, measures, samples);
}

/// Turns the head from the layers' normals to where it is clear. Tips and heights stay those of the layers.
void leanHead(const GrownPart& part, std::vector<LayerSurface>& surfaces, VolumetricMeasures& measures,
              Progress& progress) {
  if (!part.lean) return;
  measures.greatest_lean_deg = toDegrees(part.lean->greatest());
  measures.shut = part.shut();
  const auto leanLayer = [&](std::size_t i) {
    LayerSurface& surface = surfaces[i];
    for (std::size_t v = 0; v < surface.normal.size(); ++v)
      surface.normal[v] = part.lean->direction(surface.tip[v], surface.normal[v]);
  };
  parallelFor(surfaces.size(), leanLayer, progress, "head");
}

std::vector<VolumetricLayer> layersFor(const std::vector<LayerBounds>& bounds, double bed_mm) {
  std::vector<VolumetricLayer> layers(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    layers[i].plane.bounds = {bed_mm + bounds[i].bottom_mm, bed_mm + bounds[i].top_mm};
  return layers;
}

bool isEmpty(const VolumetricLayer& layer) { return layer.isLevel() && layer.plane.section.contours.empty(); }

}  // namespace

VolumetricLayers volumetricLayers(const Mesh& mesh, const MeshTopology& topology,
                                  const VolumetricRequest& request, Progress& progress) {
  requireClosed(mesh, topology);
  const GrownPart part = grownPart(mesh, request, progress);
  const GrowthLattice& lattice = *part.lattice;
  VolumetricLayers result;
  measureField(part, result.measures);
  result.hanging = part.hanging.grown;
  result.room = part.room;
  const std::vector<LayerBounds> bounds = growthBounds(part);
  result.layers = layersFor(bounds, part.bed_mm);
  const std::vector<char> is_level = levelLayers(part.cells(), lattice, bounds, part.bed_mm);
  cutLevelLayers(part, topology, is_level, result.layers, progress);
  const SignedDistance skin(mesh);
  std::vector<LayerSurface> surfaces =
      growthSurfaces(lattice, part.cells(), {bounds, is_level}, skin, progress);
  result.measures.left_out_mm3 = leaveOutCrumbs(surfaces, request.bead_mm, progress);
  measureResting(part, surfaces, result.measures, progress);
  measureCoverage(part, topology, {result.layers, surfaces}, result.measures, progress);
  leanHead(part, surfaces, result.measures, progress);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!result.layers[i].plane.section.contours.empty()) ++result.measures.level_layers;
    result.layers[i].surface = std::move(surfaces[i]);
  }
  result.layers.erase(std::remove_if(result.layers.begin(), result.layers.end(), isEmpty),
                      result.layers.end());
  if (result.layers.empty()) throw InvalidInput("no layer of the part has room for a bead");
  return result;
}

}  // namespace lamina
