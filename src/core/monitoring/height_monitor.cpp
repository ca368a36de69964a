// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/height_monitor.hpp"

#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

HeightGrid gridAround(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                      const MonitorSettings& settings) {
  Box2 area;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) area.include((bed_from_part * point).head<2>());
  if (area.isEmpty())
    throw InvalidInput("toolpath '" + toolpath.part_name + "' deposits nothing; nothing to measure");
  const Point2 margin(settings.margin_mm, settings.margin_mm);
  return heightGrid({area.low - margin, area.high + margin}, settings.cell_mm);
}

}  // namespace

HeightMonitor::HeightMonitor(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                             const MonitorSettings& settings)
    : toolpath_(std::move(toolpath)),
      bed_from_part_(bed_from_part),
      clock_(toolpath_, bed_from_part, settings.scan_clearance_mm),
      measured_(gridAround(toolpath_, bed_from_part, settings)),
      expected_(measured_.grid(), bed_from_part),
      deviation_(measured_.grid()) {}

std::optional<LayerHeightReport> HeightMonitor::insert(const std::vector<Point3>& points,
                                                       std::optional<double> nozzle_height) {
  const auto layer = nozzle_height ? clock_.observe(*nozzle_height) : std::nullopt;
  std::optional<LayerHeightReport> report;
  if (layer != scanned_) {
    report = close();
    if (layer) begin(*layer);
  }
  ++(layer ? profiles_of_layers_ : other_profiles_);
  fuse(points);
  return report;
}

void HeightMonitor::fuse(const std::vector<Point3>& points) {
  std::size_t first = 0;
  for (const Point3& point : points) {
    const MeasuredSurface::Fused fused = measured_.insert(point);
    first += fused == MeasuredSurface::Fused::First ? 1 : 0;
    points_outside_ += fused == MeasuredSurface::Fused::Outside ? 1 : 0;
  }
  if (scanned_) cells_in_scan_ += first;
}

void HeightMonitor::begin(std::size_t layer) {
  measured_.beginPass();
  scanned_ = layer;
  while (layers_expected_ <= layer) expected_.addLayer(toolpath_.layers[layers_expected_++]);
}

std::optional<LayerHeightReport> HeightMonitor::finish() {
  clock_.finish();
  return close();
}

std::optional<LayerHeightReport> HeightMonitor::close() {
  if (!scanned_) return std::nullopt;
  LayerHeightReport report;
  report.layer = *scanned_;
  report.expected_height_mm = (bed_from_part_ * Point3(0.0, 0.0, toolpath_.layers[*scanned_].z_mm)).z();
  HeightComparison comparison = compareHeights(measured_, expected_, std::move(deviation_));
  report.statistics = comparison.statistics;
  deviation_ = std::move(comparison.deviation);
  scanned_.reset();
  cells_in_scan_ = 0;
  measured_.beginPass();
  return report;
}

void describe(SettingsSchema& schema, MonitorSettings& settings) {
  schema.number("monitor.cell_mm", settings.cell_mm, {0.0, 100.0, true}, "Cell size of the height maps.");
  schema.number("monitor.margin_mm", settings.margin_mm, {0.0, 1000.0},
                "Extent of the height maps around what the toolpath deposits.");
  schema.number("scan.clearance_mm", settings.scan_clearance_mm, {0.0, 100.0, true},
                "Clearance that the toolpath's scan passes were planned with.");
}

}  // namespace lamina
