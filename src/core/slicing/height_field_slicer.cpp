// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field_slicer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/surface/subdivision.hpp"
#include "slicing/bend_limits.hpp"
#include "slicing/followed_cells.hpp"
#include "slicing/height_field_fit.hpp"
#include "slicing/top_surface.hpp"

namespace lamina {
namespace {

constexpr double kMostCells = 4e6;
/// Rings of cells around the part.
constexpr double kMargin = 2.0;

void requireValid(HeightFieldSettings settings) {
  SettingsSchema schema;
  describe(schema, settings);
  schema.validate();
}

HeightGrid gridOver(const Box3& box, double cell_mm) {
  const Point2 size = box.size().head<2>();
  const double count = (size.x() / cell_mm + 5.0) * (size.y() / cell_mm + 5.0);
  if (count > kMostCells)
    throw InvalidConfig("heightfield.cell_mm is " + std::to_string(cell_mm) + " mm, which makes " +
                        std::to_string(static_cast<long long>(count)) + " cells over a part of " +
                        std::to_string(size.x()) + " x " + std::to_string(size.y()) +
                        " mm; must make at most four million");
  const Point2 margin = Point2::Constant(kMargin * cell_mm);
  return heightGrid({box.low.head<2>() - margin, box.high.head<2>() + margin}, cell_mm);
}

double levelTop(const Mesh& mesh, const HeightField& field) {
  double top = field.base_mm;
  for (const Point3& vertex : mesh.vertices) top = std::max(top, field.level(vertex).z());
  return top;
}

/// Heights at which whole layers end, the nearest to `height` first.
std::vector<double> wholeLayers(double height, const SlicingSettings& slicing) {
  const double above = (height - slicing.first_layer_height_mm) / slicing.layer_height_mm;
  std::vector<double> heights;
  for (const double count : {std::round(above), std::floor(above), std::ceil(above)})
    if (count >= 0.0) heights.push_back(slicing.first_layer_height_mm + count * slicing.layer_height_mm);
  return heights;
}

/// Thickens all layers so that the highest place of the part is at the top of one, as far as the limits
/// allow.
void endOnWholeLayer(HeightField& field, const Mesh& mesh, const TopSurface& top,
                     const SlicingSettings& slicing, const HeightFieldSettings& settings) {
  const double height = levelTop(mesh, field) - field.base_mm;
  const FactorRange range = factorRange(field, top);
  for (const double whole : wholeLayers(height, slicing)) {
    const double scale = height / whole;
    if (range.least * scale < settings.min_thickness || range.greatest * scale > settings.max_thickness)
      continue;
    for (double& factor : field.factor) factor *= scale;
    return;
  }
}

double distanceToTops(double z, const std::vector<LayerSlab>& slabs) {
  double least = std::numeric_limits<double>::infinity();
  const auto above = std::lower_bound(
      slabs.begin(), slabs.end(), z, [](const LayerSlab& slab, double value) { return slab.top_mm < value; });
  if (above != slabs.end()) least = std::abs(above->top_mm - z);
  if (above != slabs.begin()) least = std::min(least, std::abs((above - 1)->top_mm - z));
  return least;
}

/// Adds what is to be told of the surface.
void tellOfSurface(const std::vector<char>& is_followed, const TopSurface& top,
                   const SlicingSettings& slicing, HeightFieldSlices& slices) {
  const HeightField& field = slices.field;
  HeightFieldReport& report = slices.report;
  std::vector<LayerSlab> bent;
  for (const Layer& layer : slices.layers) bent.push_back(layer.slab);
  const std::vector<LayerSlab> level = stackLayers(field.base_mm, slices.top_mm, slicing);
  const double area = field.cells.cell_mm * field.cells.cell_mm;
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < is_followed.size(); ++cell) {
    const int column = field.cells.column(cell);
    const int row = field.cells.row(cell);
    const std::optional<double>& height = top.at_corner[field.corner(column, row)];
    if (!height || !(top.over_half[2 * cell] || top.over_half[2 * cell + 1])) continue;
    report.upper_mm2 += area;
    if (is_followed[cell] == 0) continue;
    report.followed_mm2 += area;
    const double factor = field.factor[field.corner(column, row)];
    report.level_error_mm += distanceToTops(field.base_mm + *height, level);
    report.bent_error_mm += factor * distanceToTops(field.base_mm + *height / factor, bent);
    ++count;
  }
  report.level_error_mm /= static_cast<double>(std::max<std::size_t>(count, 1));
  report.bent_error_mm /= static_cast<double>(std::max<std::size_t>(count, 1));
}

std::string rounded(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::vector<std::string> notesOf(const HeightFieldReport& report, const HeightFieldSettings& settings) {
  if (report.followed_mm2 == 0.0)
    return {"No upper surface is flatter than heightfield.max_slope_deg " +
            rounded(settings.max_slope_deg, "%g") + " deg: the layers are level."};
  std::vector<std::string> notes = {
      "Layers bend up to " + rounded(report.greatest_slope_deg, "%.2f") + " deg and are " +
          rounded(report.least_thickness_mm, "%.3f") + " to " +
          rounded(report.greatest_thickness_mm, "%.3f") + " mm thick.",
      "They follow " + rounded(100.0 * report.followed_mm2 / report.upper_mm2, "%.0f") +
          " % of the upper side; its mean distance from the nearest layer's top is " +
          rounded(report.bent_error_mm, "%.4f") + " mm, that of level layers would be " +
          rounded(report.level_error_mm, "%.4f") + " mm."};
  if (report.share < 1.0)
    notes.push_back("The bend is " + rounded(100.0 * report.share, "%.1f") +
                    " % of what the surface asks for, to keep within heightfield.max_slope_deg " +
                    rounded(settings.max_slope_deg, "%g") + " deg and a thickness of " +
                    rounded(settings.min_thickness, "%g") + " to " + rounded(settings.max_thickness, "%g") +
                    " layer heights.");
  return notes;
}

HeightFieldSlices sliceByHeightField(const Mesh& mesh, const SlicingSettings& slicing,
                                     const HeightFieldSettings& settings, Progress& progress) {
  requireValid(settings);
  const Box3 box = boundingBox(mesh);
  if (box.isEmpty() || !(box.size().z() > 0.0))
    throw InvalidMesh("the mesh has " + std::to_string(mesh.triangles.size()) +
                      " triangles and no height; a solid part is needed");
  const HeightGrid cells = gridOver(box, settings.cell_mm);
  Mesh fine = subdivide(mesh, settings.cell_mm).mesh;
  progress.report("bend", 0.2);
  throwIfCancelled(progress, "bend");
  const TopSurface top = topSurface(fine, cells, box.low.z());
  const std::vector<char> is_followed = followedCells(top, cells, settings);
  const std::vector<double> log_factor = fitHeightField(top, cells, is_followed, settings);
  progress.report("bend", 0.8);
  throwIfCancelled(progress, "bend");
  LimitedBend bend = limitedBend(cells, box.low.z(), log_factor, top, settings);
  endOnWholeLayer(bend.field, fine, top, slicing, settings);

  HeightFieldSlices slices;
  slices.top_mm = box.high.z();
  slices.report.share = bend.share;
  slices.report.greatest_slope_deg = std::atan(steepestSlope(bend.field, top)) * 180.0 / M_PI;
  const FactorRange range = factorRange(bend.field, top);
  slices.report.least_thickness_mm = range.least * slicing.layer_height_mm;
  slices.report.greatest_thickness_mm = range.greatest * slicing.layer_height_mm;
  slices.field = std::move(bend.field);
  const double level_top = levelTop(fine, slices.field);
  const Mesh level = levelled(std::move(fine), slices.field);
  progress.report("bend", 1.0);
  std::vector<double> heights;
  for (const LayerSlab& slab : stackLayers(box.low.z(), level_top, slicing)) {
    slices.layers.push_back({slab, {}});
    heights.push_back(slab.cut());
  }
  std::vector<Section> sections = sliceMesh(level, heights, progress);
  for (std::size_t i = 0; i < sections.size(); ++i) slices.layers[i].section = std::move(sections[i]);
  tellOfSurface(is_followed, top, slicing, slices);
  return slices;
}

}  // namespace lamina
