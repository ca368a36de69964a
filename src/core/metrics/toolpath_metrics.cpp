// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/toolpath_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "lamina/base/layer_error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/metrics/surface_fill.hpp"
#include "lamina/metrics/volume_error.hpp"
#include "lamina/trajectory/rest_to_rest.hpp"

namespace lamina {
namespace {

/// A built-in metric: its name, what it means, and where it stands.
struct NamedField {
  const char* name;
  double ToolpathMetrics::*value;
  const char* meaning;
  MetricNeed need = MetricNeed::Path;
};

constexpr std::array<NamedField, 9> kBuiltInMetrics{{
    {"print_time_s", &ToolpathMetrics::print_time_s, "Time from rest to rest on every motion [s]"},
    {"material_mm", &ToolpathMetrics::material_mm, "Length along which material is deposited [mm]"},
    {"travel_mm", &ToolpathMetrics::travel_mm, "Length along which none is deposited [mm]"},
    {"under_fill_mm2", &ToolpathMetrics::under_fill_mm2, "Surface that no bead covers [mm2]",
     MetricNeed::Surface},
    {"over_fill_mm2", &ToolpathMetrics::over_fill_mm2, "Surface that beads cover twice [mm2]",
     MetricNeed::Surface},
    {"volume_error_mm3", &ToolpathMetrics::volume_error_mm3,
     "Between the volume deposited and the volume asked for [mm3]"},
    {"control_energy_nm2_s", &ToolpathMetrics::control_energy_nm2_s,
     "Squared torques of the six-legged platform over time [(N m)2 s]", MetricNeed::Platform},
    {"linear_ise_mm2_s", &ToolpathMetrics::linear_ise_mm2_s,
     "Squared error of its nozzle's tip over time [mm2 s]", MetricNeed::Platform},
    {"rotational_ise_rad2_s", &ToolpathMetrics::rotational_ise_rad2_s,
     "Squared errors of its turns over time [rad2 s]", MetricNeed::Platform},
}};

std::map<std::string, Metric> builtInMetrics() {
  std::map<std::string, Metric> metrics;
  for (const NamedField& field : kBuiltInMetrics)
    metrics[field.name] = {
        field.meaning, [value = field.value](const MetricRequest& request) { return request.nine.*value; },
        field.need};
  return metrics;
}

const NamedField* fieldOf(const std::string& name) {
  const auto found = std::find_if(kBuiltInMetrics.begin(), kBuiltInMetrics.end(),
                                  [&](const NamedField& field) { return name == field.name; });
  return found != kBuiltInMetrics.end() ? &*found : nullptr;
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

/// Some of the paths of a toolpath, all layers counted through.
struct PathRange {
  std::size_t first = 0;
  std::size_t last = 0;  ///< not included
};

/// From the first run that deposits to the last: slicers come from home and park out of reach, which says
/// nothing about the path, and programs do not state where the machine stood before. Empty if nothing
/// deposits.
PathRange printedRange(const Toolpath& toolpath) {
  PathRange range;
  std::size_t path_number = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role != PathRole::Travel) {
        if (range.last == 0) range.first = path_number;
        range.last = path_number + 1;
      }
      ++path_number;
    }
  return range;
}

Toolpath onlyPrinted(Toolpath toolpath) {
  const PathRange printed = printedRange(toolpath);
  std::size_t path_number = 0;
  for (ToolpathLayer& layer : toolpath.layers) {
    const auto is_outside = [&](const Path&) {
      const bool outside = path_number < printed.first || path_number >= printed.last;
      ++path_number;
      return outside;
    };
    layer.paths.erase(std::remove_if(layer.paths.begin(), layer.paths.end(), is_outside), layer.paths.end());
  }
  return toolpath;
}

void addMotions(ToolpathMetrics& metrics, const Toolpath& toolpath, const MetricsSettings& settings) {
  const PathRange printed = printedRange(toolpath);
  std::size_t path_number = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      const bool is_printed = path_number >= printed.first && path_number < printed.last;
      ++path_number;
      if (!is_printed) continue;
      for (std::size_t m = 0; m < path.motionCount(); ++m) addMotion(metrics, path, m, settings);
    }
}

void simulate(ToolpathMetrics& metrics, const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
              const MetricsSettings& settings, Progress& progress) {
  const Toolpath timed = onlyPrinted(atSpeed(toolpath, settings.speed_mm_s));
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

/// Those of plug-ins. One whose need was not asked for is left out.
std::map<std::string, double> measureAdded(const MetricRequest& request) {
  std::map<std::string, double> values;
  for (const std::string& name : toolpathMetrics().names()) {
    const std::vector<std::string>& left_out = request.settings.left_out;
    const bool is_left_out = std::find(left_out.begin(), left_out.end(), name) != left_out.end();
    if (fieldOf(name) != nullptr || is_left_out) continue;
    const Metric metric = toolpathMetrics().find(name);
    if (metric.need == MetricNeed::Surface && !request.settings.measures_surface) continue;
    if (metric.need == MetricNeed::Platform && !request.settings.simulates_platform) continue;
    try {
      values[name] = metric.measure(request);
    } catch (...) {
      rethrowAt("metric '" + name + "'");
    }
  }
  return values;
}

}  // namespace

Registry<Metric>& toolpathMetrics() {
  static Registry<Metric> registry("the metric", builtInMetrics());
  return registry;
}

std::vector<std::string> metricNames() {
  std::vector<std::string> names;
  names.reserve(kBuiltInMetrics.size());
  for (const NamedField& field : kBuiltInMetrics) names.emplace_back(field.name);
  for (std::string& name : toolpathMetrics().names())
    if (fieldOf(name) == nullptr) names.push_back(std::move(name));
  return names;
}

std::vector<std::string> metricMeanings() {
  std::vector<std::string> meanings;
  for (const std::string& name : metricNames()) meanings.push_back(toolpathMetrics().find(name).meaning);
  return meanings;
}

std::vector<double> metricValues(const ToolpathMetrics& metrics) {
  std::vector<double> values;
  for (const std::string& name : metricNames()) {
    const NamedField* field = fieldOf(name);
    const auto added = metrics.added.find(name);
    if (field != nullptr)
      values.push_back(metrics.*field->value);
    else
      values.push_back(added != metrics.added.end() ? added->second
                                                    : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

ToolpathMetrics measureToolpath(const Toolpath& toolpath, const Mesh& part,
                                const Eigen::Isometry3d& bed_from_part, const MetricsSettings& settings,
                                Progress& progress) {
  ToolpathMetrics metrics;
  addMotions(metrics, toolpath, settings);
  metrics.volume_error_mm3 = volumeError(toolpath, std::abs(volume(part)), settings.volume);
  if (settings.measures_surface) {
    const SurfaceFill fill = measureSurfaceFill(toolpath, part, bed_from_part, settings.surface, progress);
    metrics.under_fill_mm2 = fill.under_fill_mm2;
    metrics.over_fill_mm2 = fill.over_fill_mm2;
  }
  if (settings.simulates_platform) simulate(metrics, toolpath, bed_from_part, settings, progress);
  metrics.added = measureAdded({toolpath, part, bed_from_part, settings, metrics});
  return metrics;
}

MetricsSettings onlyFor(const std::vector<std::string>& metrics, MetricsSettings settings) {
  settings.measures_surface = settings.simulates_platform = false;
  settings.left_out = toolpathMetrics().names();
  for (const std::string& name : metrics) {
    if (!toolpathMetrics().has(name))
      throw InvalidConfig("there is no metric '" + name + "'; expected one of " + listed(metricNames()));
    const MetricNeed need = toolpathMetrics().find(name).need;
    settings.left_out.erase(std::remove(settings.left_out.begin(), settings.left_out.end(), name),
                            settings.left_out.end());
    settings.measures_surface = settings.measures_surface || need == MetricNeed::Surface;
    settings.simulates_platform = settings.simulates_platform || need == MetricNeed::Platform;
  }
  return settings;
}

}  // namespace lamina
