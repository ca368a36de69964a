// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/base/registry.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Nine numbers that say how good a toolpath is for a part, all to be small [Guacheta2021, table 4-2].
/// What was not measured is not a number.
///
/// Time and lengths are counted from the first run that deposits to the last, skirts included: neither the
/// way from home nor that to where the machine parks. Zero where nothing deposits.
struct ToolpathMetrics {
  double print_time_s = 0.0;  ///< from rest to rest on every motion
  double material_mm = 0.0;   ///< length along which material is deposited
  double travel_mm = 0.0;     ///< length along which none is
  double under_fill_mm2 = std::numeric_limits<double>::quiet_NaN();  ///< surface that no bead covers
  double over_fill_mm2 = std::numeric_limits<double>::quiet_NaN();   ///< surface that is covered twice
  double volume_error_mm3 = 0.0;  ///< between what is deposited and what is asked for, whichever is more
  double control_energy_nm2_s = std::numeric_limits<double>::quiet_NaN();   ///< of the six-legged platform
  double linear_ise_mm2_s = std::numeric_limits<double>::quiet_NaN();       ///< of its nozzle's tip
  double rotational_ise_rad2_s = std::numeric_limits<double>::quiet_NaN();  ///< of its turns
  std::map<std::string, double> added = {};  ///< what metrics of plug-ins gave, by name
};

/// What a metric is measured on.
struct MetricRequest {
  const Toolpath& toolpath;  ///< in the frame of the part
  const Mesh& part;          ///< closed, facing outwards
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  const MetricsSettings& settings;
  const ToolpathMetrics& nine;  ///< as far as they are asked for
};

/// What has to be done for a metric; what none needs is not done.
enum class MetricNeed {
  Path,      ///< a walk along the toolpath
  Surface,   ///< `measureSurfaceFill`
  Platform,  ///< the simulated platform
};

/// One number that says how good a toolpath is for a part, to be small.
struct Metric {
  std::string meaning;  ///< a sentence with its unit
  /// The same whatever the number of threads; not a number if it was not measured.
  std::function<double(const MetricRequest& request)> measure;
  MetricNeed need = MetricNeed::Path;
};

/// All metrics, those of plug-ins too. Whoever adds one calls `toolpathMetrics().add("name_unit", {...})`.
Registry<Metric>& toolpathMetrics();

/// The names of all metrics: the nine in their order, then those added, in alphabetical order.
std::vector<std::string> metricNames();

/// The values in the order of `metricNames`; of one that was not measured, not a number.
std::vector<double> metricValues(const ToolpathMetrics& metrics);

/// What each is, a sentence with its unit, in the order of `metricNames`.
std::vector<std::string> metricMeanings();

/// Measures a toolpath against the part that it is to make. The same whatever the number of threads.
/// @param toolpath       in the frame of the part
/// @param part           closed, facing outwards
/// @param bed_from_part  [mm]; how the part is turned says which faces are level
/// @param progress       stages "surface", and "simulate" if the platform is asked for
/// @throws InvalidInput if a feed is not positive where it counts; what an added metric throws, with its name
/// @throws Unreachable if the platform is asked for and cannot follow
/// @throws Cancelled
ToolpathMetrics measureToolpath(const Toolpath& toolpath, const Mesh& part,
                                const Eigen::Isometry3d& bed_from_part, const MetricsSettings& settings,
                                Progress& progress);

/// The settings by which no more is done than these metrics need.
/// @throws InvalidConfig if there is no metric of a name
MetricsSettings onlyFor(const std::vector<std::string>& metrics, MetricsSettings settings);

}  // namespace lamina
