// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/layer_clock.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/scan_height.hpp"

namespace lamina {
namespace {

constexpr double kSteady =
    1e-3;  // mm between two observations: a nozzle that changes height neither prints a layer nor scans it

constexpr double kLevelOnBed = 1e-9;  // sine

}  // namespace

Eigen::Isometry3d heightsFromPart(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part) {
  const Point3 normal = bed_from_part.linear() * layerNormal(toolpath);
  if (normal.z() > 0.0 && normal.head<2>().norm() < kLevelOnBed) return bed_from_part;
  return Eigen::Isometry3d(toolpath.part_from_layers.conjugate());
}

LayerClock::LayerClock(const Toolpath& toolpath, const Eigen::Isometry3d& heights_from_part,
                       double clearance_mm) {
  const Point3 normal = layerNormal(toolpath);
  const auto heightOf = [&](double z) { return (heights_from_part * Point3(z * normal)).z(); };
  for (std::size_t i = 0; i < toolpath.layers.size(); ++i) {
    const ToolpathLayer& layer = toolpath.layers[i];
    const double tolerance = 0.25 * layer.height_mm;
    prints_.push_back({heightOf(layer.z_mm), tolerance, i});
    if (isScanned(layer, clearance_mm, normal))
      scans_.push_back({heightOf(scanHeight(layer, clearance_mm)), tolerance, i});
  }
  const auto isLower = [](const Mark& a, const Mark& b) { return a.height_mm < b.height_mm; };
  std::sort(scans_.begin(), scans_.end(), isLower);
  std::sort(prints_.begin(), prints_.end(), isLower);
}

std::optional<std::size_t> LayerClock::observe(double nozzle_height_mm) {
  const bool is_steady = last_height_mm_ && std::abs(*last_height_mm_ - nozzle_height_mm) < kSteady;
  last_height_mm_ = nozzle_height_mm;
  if (is_steady) notePrinting(nozzle_height_mm);
  const auto layer = layerAt(scans_, nozzle_height_mm);
  if (layer == scanned_) return scanned_;
  finish();
  if (layer && is_steady && isDue(*layer)) scanned_ = layer;
  return scanned_;
}

void LayerClock::finish() {
  if (scanned_ && is_seen_) first_open_ = std::max(first_open_, *scanned_ + 1);
  scanned_.reset();
  is_seen_ = false;
}

std::vector<std::size_t> LayerClock::scannedLayers() const {
  std::vector<std::size_t> layers;
  for (const Mark& scan : scans_) layers.push_back(scan.layer);
  std::sort(layers.begin(), layers.end());
  return layers;
}

void LayerClock::notePrinting(double nozzle_height_mm) {
  const auto layer = layerAt(prints_, nozzle_height_mm);
  if (layer) printed_ = layer;
}

bool LayerClock::isDue(std::size_t layer) const {
  if (layer < first_open_) return false;
  const auto next = std::find_if(scans_.begin(), scans_.end(),
                                 [this](const Mark& scan) { return scan.layer >= first_open_; });
  if (next != scans_.end() && next->layer == layer) return true;
  // A hop by one layer height looks like printing the next layer.
  return printed_ && (*printed_ == layer || *printed_ == layer + 1);
}

std::optional<std::size_t> LayerClock::layerAt(const std::vector<Mark>& marks, double height_mm) {
  const auto above =
      std::lower_bound(marks.begin(), marks.end(), height_mm,
                       [](const Mark& mark, double height) { return mark.height_mm < height; });
  const auto fits = [height_mm](const Mark& mark) {
    return std::abs(mark.height_mm - height_mm) <= mark.tolerance_mm;
  };
  if (above != marks.end() && fits(*above)) return above->layer;
  if (above != marks.begin() && fits(*std::prev(above))) return std::prev(above)->layer;
  return std::nullopt;
}

}  // namespace lamina
