// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/toolpath_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/metrics/surface_fill.hpp"
#include "lamina/metrics/volume_error.hpp"
#include "lamina/trajectory/rest_to_rest.hpp"

namespace lamina {
namespace {

/// One of the nine.
struct Metric {
  const char* name;
  double ToolpathMetrics::*value;
  const char* meaning;
};

constexpr std::array<Metric, 9> kMetrics{{
    {"print_time_s", &ToolpathMetrics::print_time_s, "Time from rest to rest on every motion [s]"},
    {"material_mm", &ToolpathMetrics::material_mm, "Length along which material is deposited [mm]"},
    {"travel_mm", &ToolpathMetrics::travel_mm, "Length along which none is deposited [mm]"},
    {"under_fill_mm2", &ToolpathMetrics::under_fill_mm2, "Surface that no bead covers [mm2]"},
    {"over_fill_mm2", &ToolpathMetrics::over_fill_mm2, "Surface that beads cover twice [mm2]"},
    {"volume_error_mm3", &ToolpathMetrics::volume_error_mm3,
     "Between the volume deposited and the volume asked for [mm3]"},
    {"control_energy_nm2_s", &ToolpathMetrics::control_energy_nm2_s,
     "Squared torques of the six-legged platform over time [(N m)2 s]"},
    {"linear_ise_mm2_s", &ToolpathMetrics::linear_ise_mm2_s,
     "Squared error of its nozzle's tip over time [mm2 s]"},
    {"rotational_ise_rad2_s", &ToolpathMetrics::rotational_ise_rad2_s,
     "Squared errors of its turns over time [rad2 s]"},
}};

std::vector<std::string> textsOf(const char* Metric::*text) {
  std::vector<std::string> texts;
  texts.reserve(kMetrics.size());
  for (const Metric& metric : kMetrics) texts.emplace_back(metric.*text);
  return texts;
}

void addMotion(ToolpathMetrics& metrics, const Path& path, std::size_t motion,
               const MetricsSettings& settings) {
  const std::size_t end = path.motionEnd(motion);
  const double length_mm = (path.points[end] - path.points[motion]).norm();
  const bool lays =
      path.role != PathRole::Travel && path.deposit == Deposit::Bead && path.bead.at(end).width_mm > 0.0;
  (lays ? metrics.material_mm : metrics.travel_mm) += length_mm;
  const double speed = settings.speed_mm_s > 0.0 ? settings.speed_mm_s : path.feed_mm_s.at(end);
  metrics.print_time_s += restToRestTime(length_mm, speed, settings.acceleration_mm_s2);
}

Toolpath atSpeed(Toolpath toolpath, double speed_mm_s) {
  if (speed_mm_s > 0.0)
    for (ToolpathLayer& layer : toolpath.layers)
      for (Path& path : layer.paths) path.feed_mm_s = speed_mm_s;
  return toolpath;
}

/// The part on the platform's bed, turned as on the one it is made for.
Eigen::Isometry3d onPlatform(const Toolpath& toolpath, Eigen::Isometry3d bed_from_part,
                             const std::vector<double>& middle_mm) {
  if (middle_mm.empty()) return bed_from_part;
  Box3 box;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) box.include(bed_from_part * point);
  if (box.isEmpty()) return bed_from_part;
  const Point3 now = box.centre();
  bed_from_part.pretranslate(Point3(middle_mm[0] - now.x(), middle_mm[1] - now.y(), 0.0));
  return bed_from_part;
}

bool deposits(const Path& path) { return path.role != PathRole::Travel; }

/// From the first run that deposits to the last: slicers come from home and park outside the platform's
/// reach.
Toolpath withoutEnds(Toolpath toolpath) {
  auto& layers = toolpath.layers;
  for (ToolpathLayer& layer : layers) {
    const auto first = std::find_if(layer.paths.begin(), layer.paths.end(), deposits);
    const bool is_reached = first != layer.paths.end();
    layer.paths.erase(layer.paths.begin(), first);
    if (is_reached) break;
  }
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    while (!layer->paths.empty() && !deposits(layer->paths.back())) layer->paths.pop_back();
    if (!layer->paths.empty()) break;
  }
  return toolpath;
}

void simulate(ToolpathMetrics& metrics, const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
              const MetricsSettings& settings, Progress& progress) {
  const Toolpath timed = withoutEnds(atSpeed(toolpath, settings.speed_mm_s));
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = settings.acceleration_mm_s2;
  const RusDescription platform = rusDescriptionFromUrdf(kinematicModelByName("rus_platform")->urdf());
  const ToolpathReference reference(timed, onPlatform(toolpath, bed_from_part, settings.platform.middle_mm),
                                    limits, platform);
  const TrackingSimulation simulation(
      reference, platform.platform, platform.platform_from_nozzle.translation(), settings.platform.tracking);
  const TrackingFigures figures = simulateTracking(simulation, progress);
  metrics.control_energy_nm2_s = figures.control_energy_nm2_s;
  metrics.linear_ise_mm2_s = figures.linear_ise_mm2_s;
  metrics.rotational_ise_rad2_s = figures.rotational_ise_rad2_s;
}

}  // namespace

const std::vector<std::string>& metricNames() {
  static const std::vector<std::string> names = textsOf(&Metric::name);
  return names;
}

const std::vector<std::string>& metricMeanings() {
  static const std::vector<std::string> meanings = textsOf(&Metric::meaning);
  return meanings;
}

std::vector<double> metricValues(const ToolpathMetrics& metrics) {
  std::vector<double> values;
  values.reserve(kMetrics.size());
  for (const Metric& metric : kMetrics) values.push_back(metrics.*metric.value);
  return values;
}

ToolpathMetrics measureToolpath(const Toolpath& toolpath, const Mesh& part,
                                const Eigen::Isometry3d& bed_from_part, const MetricsSettings& settings,
                                Progress& progress) {
  ToolpathMetrics metrics;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t m = 0; m < path.motionCount(); ++m) addMotion(metrics, path, m, settings);
  metrics.volume_error_mm3 = volumeError(toolpath, std::abs(volume(part)), settings.volume);
  if (settings.measures_surface) {
    const SurfaceFill fill = measureSurfaceFill(toolpath, part, bed_from_part, settings.surface, progress);
    metrics.under_fill_mm2 = fill.under_fill_mm2;
    metrics.over_fill_mm2 = fill.over_fill_mm2;
  }
  if (settings.simulates_platform) simulate(metrics, toolpath, bed_from_part, settings, progress);
  return metrics;
}

MetricsSettings onlyFor(const std::vector<std::string>& metrics, MetricsSettings settings) {
  settings.measures_surface = settings.simulates_platform = false;
  for (const std::string& name : metrics) {
    const auto metric = std::find(metricNames().begin(), metricNames().end(), name);
    if (metric == metricNames().end())
      throw InvalidConfig("there is no metric '" + name + "'; expected one of " + listed(metricNames()));
    const auto index = metric - metricNames().begin();
    settings.measures_surface = settings.measures_surface || index == 3 || index == 4;
    settings.simulates_platform = settings.simulates_platform || index > 5;
  }
  return settings;
}

}  // namespace lamina
