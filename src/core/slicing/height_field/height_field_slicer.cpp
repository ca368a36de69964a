// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field/height_field_slicer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/subdivision.hpp"
#include "slicing/height_field/bend_limits.hpp"
#include "slicing/height_field/followed_cells.hpp"
#include "slicing/height_field/height_field_fit.hpp"
#include "slicing/height_field/layer_alignment.hpp"
#include "slicing/height_field/top_surface.hpp"

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

bool isPart(const TopSurface& top, std::size_t cell) {
  return top.over_half[2 * cell] || top.over_half[2 * cell + 1];
}

/// Mean slope of the followed surface against layers, times which the layers' number is that of steps.
struct StepCounts {
  double level = 0.0;
  double bent = 0.0;
};

StepCounts stepCounts(const HeightField& field, const std::vector<char>& is_followed, const TopSurface& top) {
  StepCounts sum;
  std::size_t count = 0;
  for (std::size_t half = 0; half < top.over_half.size(); ++half) {
    if (is_followed[half / 2] == 0 || !top.over_half[half]) continue;
    std::array<double, 3> heights{};
    std::array<double, 3> level{};
    const std::array<std::size_t, 3> corners = cornersOfHalf(field.cells, half);
    for (std::size_t i = 0; i < 3; ++i) {
      heights[i] = *top.prolonged[corners[i]];
      level[i] = heights[i] / field.factor[corners[i]];
    }
    sum.level += slopeOfHalf(heights, field.cells.cell_mm);
    sum.bent += slopeOfHalf(level, field.cells.cell_mm);
    ++count;
  }
  const auto most = static_cast<double>(std::max<std::size_t>(count, 1));
  return {sum.level / most, sum.bent / most};
}

double levelTop(const Mesh& mesh, const HeightField& field) {
  double top = field.base_mm;
  for (const Point3& vertex : mesh.vertices) top = std::max(top, field.level(vertex).z());
  return top;
}

/// Low corners of the cells that are followed.
std::vector<SurfacePlace> followedPlaces(const std::vector<char>& is_followed, const TopSurface& top,
                                         const HeightField& field) {
  std::vector<SurfacePlace> places;
  for (std::size_t cell = 0; cell < is_followed.size(); ++cell) {
    const std::size_t corner = field.corner(field.cells.column(cell), field.cells.row(cell));
    if (is_followed[cell] != 0 && isPart(top, cell) && top.at_corner[corner])
      places.push_back({*top.at_corner[corner], field.factor[corner]});
  }
  return places;
}

/// Reports of the bend and what it follows.
HeightFieldReport reportOf(const HeightField& field, const std::vector<char>& is_followed,
                           const TopSurface& top, const SlicingSettings& slicing) {
  HeightFieldReport report;
  report.greatest_slope_deg = std::atan(steepestSlope(field, top)) * 180.0 / M_PI;
  const FactorRange range = factorRange(field, top);
  report.least_thickness_mm = range.least * slicing.layer_height_mm;
  report.greatest_thickness_mm = range.greatest * slicing.layer_height_mm;
  const double area = field.cells.cell_mm * field.cells.cell_mm;
  for (std::size_t cell = 0; cell < is_followed.size(); ++cell) {
    if (!isPart(top, cell)) continue;
    report.upper_mm2 += area;
    if (is_followed[cell] != 0) report.followed_mm2 += area;
  }
  std::vector<SurfacePlace> places = followedPlaces(is_followed, top, field);
  report.bent_error_mm = distanceToTops(places, 1.0, slicing);
  for (SurfacePlace& place : places) place.factor = 1.0;
  report.level_error_mm = distanceToTops(places, 1.0, slicing);
  const StepCounts steps = stepCounts(field, is_followed, top);
  report.level_steps_per_mm = steps.level / slicing.layer_height_mm;
  report.bent_steps_per_mm = steps.bent / slicing.layer_height_mm;
  return report;
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
          " % of the upper side. There are " + rounded(report.bent_steps_per_mm, "%.3f") +
          " steps per mm on it, its mean distance from the nearest layer's top is " +
          rounded(report.bent_error_mm, "%.4f") + " mm; with level layers it would be " +
          rounded(report.level_steps_per_mm, "%.3f") + " and " + rounded(report.level_error_mm, "%.4f") +
          " mm."};
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
  const FactorRange range = factorRange(bend.field, top);
  const double scale =
      alignedScale(followedPlaces(is_followed, top, bend.field),
                   {settings.min_thickness / range.least, settings.max_thickness / range.greatest}, slicing);
  for (double& factor : bend.field.factor) factor *= scale;

  HeightFieldSlices slices;
  slices.top_mm = box.high.z();
  slices.report = reportOf(bend.field, is_followed, top, slicing);
  slices.report.share = bend.share;
  slices.field = std::move(bend.field);
  const double level_top = levelTop(fine, slices.field);
  const Mesh level = levelled(std::move(fine), slices.field);
  progress.report("bend", 1.0);
  std::vector<double> heights;
  for (const LayerBounds& bounds : stackLayers(box.low.z(), level_top, slicing)) {
    slices.layers.push_back({bounds, {}});
    heights.push_back(bounds.cut());
  }
  std::vector<Section> sections = sliceMesh(level, heights, progress);
  for (std::size_t i = 0; i < sections.size(); ++i) slices.layers[i].section = std::move(sections[i]);
  return slices;
}

}  // namespace lamina
