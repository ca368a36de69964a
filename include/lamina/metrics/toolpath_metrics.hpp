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

/// Nine figures of merit of a toolpath for a part, the smaller the better [Guacheta2021, table 4-2]. Those
/// that were not measured are NaN.
///
/// Time and lengths are counted from the first run that deposits to the last, skirts included, without the
/// motions from home and to where the machine parks. They are zero if nothing is deposited.
struct ToolpathMetrics {
  double print_time_s = 0.0;  ///< if every motion starts and ends at rest
  double material_mm = 0.0;   ///< length along which material is deposited
  double travel_mm = 0.0;     ///< length of the other motions
  double under_fill_mm2 = std::numeric_limits<double>::quiet_NaN();  ///< surface that no bead covers
  double over_fill_mm2 = std::numeric_limits<double>::quiet_NaN();   ///< surface that is covered twice
  double volume_error_mm3 = 0.0;  ///< absolute difference between the deposited volume and the wanted one
  /// Of the simulated six-legged platform.
  double control_energy_nm2_s = std::numeric_limits<double>::quiet_NaN();
  /// Integral of the squared error of the position of the platform's nozzle tip.
  double linear_ise_mm2_s = std::numeric_limits<double>::quiet_NaN();
  /// Integral of the squared error of the nozzle's orientation.
  double rotational_ise_rad2_s = std::numeric_limits<double>::quiet_NaN();
  std::map<std::string, double> added = {};  ///< values of the metrics of plug-ins, by name
};

/// What a metric is measured on.
struct MetricRequest {
  const Toolpath& toolpath;  ///< in the frame of the part
  const Mesh& part;          ///< closed, facing outwards
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  const MetricsSettings& settings;
  const ToolpathMetrics& nine;  ///< the nine metrics, as far as they are measured
};

/// The most expensive step that a metric needs. Steps that no metric needs are left out.
enum class MetricNeed {
  Path,      ///< a pass over the toolpath
  Surface,   ///< `measureSurfaceFill`
  Platform,  ///< the simulation of the platform
};

/// A figure of merit of a toolpath for a part, the smaller the better.
struct Metric {
  std::string meaning;  ///< description in a sentence, with the unit
  /// Returns the value, or NaN if it was not measured; must not depend on the number of threads.
  std::function<double(const MetricRequest& request)> measure;
  MetricNeed need = MetricNeed::Path;
};

/// All metrics by name, those of plug-ins included. A plug-in adds one by `toolpathMetrics().add("name_unit",
/// {...})`.
Registry<Metric>& toolpathMetrics();

/// Names of all metrics: the nine in their order, then those of plug-ins in alphabetical order.
std::vector<std::string> metricNames();

/// The values in the order of `metricNames`, NaN for those that were not measured.
std::vector<double> metricValues(const ToolpathMetrics& metrics);

/// Descriptions in the order of `metricNames`, each a sentence with the unit.
std::vector<std::string> metricMeanings();

/// Measures a toolpath against the part that it is to make. The result is the same for any number of threads.
/// @param toolpath       in the frame of the part
/// @param part           closed, facing outwards
/// @param bed_from_part  [mm]; its rotation decides which faces are level
/// @param progress       stages "surface", and "simulate" if the platform is simulated
/// @throws InvalidInput if a feed that is used is not positive; as a metric of a plug-in, with its name
/// @throws Unreachable if the platform is simulated and cannot follow
/// @throws Cancelled
ToolpathMetrics measureToolpath(const Toolpath& toolpath, const Mesh& part,
                                const Eigen::Isometry3d& bed_from_part, const MetricsSettings& settings,
                                Progress& progress);

/// The settings, changed so that only what these metrics need is computed.
/// @throws InvalidConfig if a name is not that of a metric
MetricsSettings onlyFor(const std::vector<std::string>& metrics, MetricsSettings settings);

}  // namespace lamina
