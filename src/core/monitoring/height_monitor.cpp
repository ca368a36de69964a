// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/height_monitor.hpp"

#include <iterator>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

HeightGrid gridAround(const Toolpath& toolpath, const Eigen::Isometry3d& heights_from_part,
                      const MonitorSettings& settings) {
  Box2 area;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) area.include((heights_from_part * point).head<2>());
  if (area.isEmpty())
    throw InvalidInput("toolpath '" + toolpath.part_name + "' deposits nothing; nothing to measure");
  const Point2 margin(settings.margin_mm, settings.margin_mm);
  return heightGrid({area.low - margin, area.high + margin}, settings.cell_mm);
}

}  // namespace

HeightMonitor::HeightMonitor(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                             const MonitorSettings& settings)
    : toolpath_(std::move(toolpath)),
      heights_from_part_(heightsFromPart(toolpath_, bed_from_part)),
      heights_from_bed_(heights_from_part_ * bed_from_part.inverse()),
      is_bed_frame_(heights_from_part_.matrix() == bed_from_part.matrix()),
      clock_(toolpath_, heights_from_part_, settings.scan_clearance_mm),
      measured_(gridAround(toolpath_, heights_from_part_, settings)),
      expected_(measured_.grid(), heights_from_part_),
      deviation_(measured_.grid()),
      to_report_(clock_.scannedLayers()) {
  // A place on the bed stays the same to the last bit where its height is one over the bed.
  if (is_bed_frame_) heights_from_bed_.setIdentity();
}

LayerHeightReports HeightMonitor::move(double nozzle_height) {
  at_scan_of_ = clock_.observe(nozzle_height);
  if (!scanned_ || at_scan_of_ == scanned_) return {};
  return {close(LayerSight::Seen)};
}

LayerHeightReports HeightMonitor::add(const std::vector<Point3>& points) {
  LayerHeightReports missed;
  if (at_scan_of_ && !scanned_) {
    missed = missedBelow(*at_scan_of_);
    begin(*at_scan_of_);
  }
  ++(scanned_ ? profiles_of_layers_ : other_profiles_);
  if (scanned_) ++profiles_in_scan_;
  fuse(points);
  return missed;
}

LayerHeightReports HeightMonitor::insert(const std::vector<Point3>& points, double nozzle_height) {
  LayerHeightReports reports = move(nozzle_height);
  LayerHeightReports missed = add(points);
  std::move(missed.begin(), missed.end(), std::back_inserter(reports));
  return reports;
}

void HeightMonitor::fuse(const std::vector<Point3>& points) {
  std::size_t first = 0;
  for (const Point3& point : points) {
    const MeasuredSurface::Fused fused =
        measured_.insert(is_bed_frame_ ? point : Point3(heights_from_bed_ * point));
    first += fused == MeasuredSurface::Fused::First ? 1 : 0;
    points_outside_ += fused == MeasuredSurface::Fused::Outside ? 1 : 0;
  }
  if (scanned_) cells_in_scan_ += first;
}

void HeightMonitor::begin(std::size_t layer) {
  measured_.beginPass();
  scanned_ = layer;
  clock_.see();
  while (layers_expected_ <= layer) expected_.addLayer(toolpath_.layers[layers_expected_++]);
}

LayerHeightReports HeightMonitor::closeScan(LayerSight sight) {
  clock_.finish();
  at_scan_of_.reset();
  if (!scanned_) return {};
  return {close(sight)};
}

LayerHeightReports HeightMonitor::finish() {
  LayerHeightReports reports = closeScan(LayerSight::Seen);
  if (!clock_.printed()) return reports;
  LayerHeightReports missed = missedBelow(*clock_.printed() + 1);
  std::move(missed.begin(), missed.end(), std::back_inserter(reports));
  return reports;
}

LayerHeightReports HeightMonitor::missedBelow(std::size_t layer) {
  LayerHeightReports missed;
  for (; reported_ < to_report_.size() && to_report_[reported_] < layer; ++reported_) {
    missed.push_back(reportOf(to_report_[reported_]));
    missed.back().sight = LayerSight::NotSeen;
  }
  return missed;
}

LayerHeightReport HeightMonitor::reportOf(std::size_t layer) const {
  LayerHeightReport report;
  report.layer = layer;
  const Point3 top = toolpath_.layers[layer].z_mm * layerNormal(toolpath_);
  report.expected_height_mm = (heights_from_part_ * top).z();
  return report;
}

LayerHeightReport HeightMonitor::close(LayerSight sight) {
  LayerHeightReport report = reportOf(*scanned_);
  HeightComparison comparison = compareHeights(measured_, expected_, std::move(deviation_));
  report.statistics = comparison.statistics;
  report.sight = comparison.statistics.cells > 0 ? sight : LayerSight::NotSeen;
  report.profiles = profiles_in_scan_;
  deviation_ = std::move(comparison.deviation);
  while (reported_ < to_report_.size() && to_report_[reported_] <= report.layer) ++reported_;
  scanned_.reset();
  cells_in_scan_ = profiles_in_scan_ = 0;
  measured_.beginPass();
  return report;
}

const char* toString(LayerSight sight) {
  switch (sight) {
    case LayerSight::Seen:
      return "seen";
    case LayerSight::CutShort:
      return "cut_short";
    case LayerSight::NotSeen:
      return "not_seen";
  }
  return "";
}

void describe(SettingsSchema& schema, MonitorSettings& settings) {
  schema.number("monitor.cell_mm", settings.cell_mm, Bounds::above(0.0, 100.0),
                "Cell size of the height maps.");
  schema.number("monitor.margin_mm", settings.margin_mm, {0.0, 1000.0},
                "Extent of the height maps around what the toolpath deposits.");
  schema.number("scan.clearance_mm", settings.scan_clearance_mm, Bounds::above(0.0, 100.0),
                "Clearance that the toolpath's scan passes were planned with.");
  schema.number("pose_gap_mm", settings.pose_gap_mm, Bounds::above(0.0, 1e6),
                "Between two known poses of the nozzle; profiles in a longer gap are not placed.");
  schema.number("quiet_s", settings.quiet_s, Bounds::above(0.0, 3600.0),
                "A scan that shows nothing new of its layer for that long, by the stamps, is over.");
}

}  // namespace lamina
