// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/metrics/toolpath_metrics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "support/random_toolpath.hpp"
#include "support/scoped_entry.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

ToolpathMetrics measure(const Toolpath& toolpath, const MetricsSettings& settings = {}) {
  NoProgress nobody;
  return measureToolpath(toolpath, makePart("box"), Eigen::Isometry3d::Identity(), settings, nobody);
}

Toolpath straight(const std::vector<double>& lengths) {
  Path path = test::straightPath({0, 0, 0.2}, {1, 0, 0.2});
  path.points = {{0, 0, 0.2}};
  for (const double length : lengths) path.points.emplace_back(path.points.back() + Point3(length, 0, 0));
  return {"line", {{0.2, 0.2, {path}}}};
}

TEST(ToolpathMetrics, TimeIsThatOfTheSource) {
  // 50 mm/s, 1000 mm/s2 [Guacheta2021, eq. 4.5].
  EXPECT_NEAR(measure(straight({1.0})).print_time_s, 0.063246, 1e-6);
  EXPECT_NEAR(measure(straight({2.5})).print_time_s, 0.1, 1e-9);
  EXPECT_NEAR(measure(straight({10.0})).print_time_s, 0.25, 1e-9);
  EXPECT_NEAR(measure(straight({10.0, 10.0})).print_time_s, 0.5, 1e-9);
  EXPECT_NEAR(measure(straight({10.0, 0.0})).print_time_s, 0.25, 1e-9);
}

TEST(ToolpathMetrics, TimeMayBeAtTheFeedsOfTheToolpath) {
  Toolpath slow = straight({10.0});
  slow.layers[0].paths[0].feed_mm_s = 10.0;
  MetricsSettings settings;
  settings.speed_mm_s = 0.0;
  EXPECT_NEAR(measure(slow, settings).print_time_s, 1.0 + 0.01, 1e-9);
}

TEST(ToolpathMetrics, MaterialAndTravelOfAProgramAreItsLength) {
  // Modal axes, a retraction, and a motion without E, which lays nothing.
  const std::string program =
      "G90\nM83\nG92 E0\nG1 Z0.2 F1200\nG1 X10 Y0 F3000\nG1 X20 E0.4\nG1 Y10 E0.4\nG1 E-1\nG1 X0\nG1 E1\n"
      "G1 X0 Y0 E0.4\n";
  const Toolpath toolpath = toolpathFromGcode(program, {}, "fixture");
  const ToolpathMetrics metrics = measure(toolpath);
  EXPECT_NEAR(metrics.material_mm, 10.0 + 10.0 + 10.0, 1e-6);
  EXPECT_NEAR(metrics.travel_mm, 20.0, 1e-6);
}

TEST(ToolpathMetrics, CountFromTheFirstRunThatDepositsToTheLast) {
  // 10 mm deposited, 30 mm of travel, 10 mm deposited; home and parking are 100 mm away. 50 mm/s, 0.05 s to
  // start and stop.
  const auto travel = [](const Point3& from, const Point3& to) {
    Path path = test::straightPath(from, to);
    path.role = PathRole::Travel;
    path.bead = Bead{0.0, 0.2};
    return path;
  };
  const Path first = test::straightPath({0, 0, 0.2}, {10, 0, 0.2});
  const Path second = test::straightPath({10, 30, 0.4}, {0, 30, 0.4});
  const Path between = travel({10, 0, 0.4}, {10, 30, 0.4});
  const Toolpath bare{"bare", {{0.2, 0.2, {first}}, {0.4, 0.2, {between, second}}}};
  Toolpath whole = bare;
  auto& paths = whole.layers[0].paths;
  paths.insert(paths.begin(), {travel({0, 0, 0}, {0, 0, 100}), travel({0, 0, 100}, {0, 0, 0.2})});
  whole.layers[1].paths.push_back(travel({0, 30, 0.4}, {0, 30, 100}));
  whole.layers.push_back({100.0, 0.2, {travel({0, 30, 100}, {0, 130, 100})}});
  for (const Toolpath& toolpath : {bare, whole}) {
    const ToolpathMetrics metrics = measure(toolpath);
    EXPECT_NEAR(metrics.material_mm, 20.0, 1e-9);
    EXPECT_NEAR(metrics.travel_mm, 30.0, 1e-9);
    EXPECT_NEAR(metrics.print_time_s, 50.0 / 50.0 + 3 * 0.05, 1e-9);
  }
  const ToolpathMetrics nothing = measure({"nothing", {{0.2, 0.2, {between}}}});
  EXPECT_EQ(nothing.travel_mm, 0.0);
  EXPECT_EQ(nothing.print_time_s, 0.0);
}

TEST(ToolpathMetrics, MaterialAndTravelAreTheWholeLength) {
  EXPECT_TRUE(rc::check("every motion from the first run that deposits to the last is either", [] {
    const Toolpath toolpath = test::randomToolpath(*rc::gen::arbitrary<std::uint64_t>());
    double all_mm = 0.0;
    double since_last_mm = 0.0;
    bool has_begun = false;
    for (const ToolpathLayer& layer : toolpath.layers)
      for (const Path& path : layer.paths) {
        has_begun = has_begun || path.role != PathRole::Travel;
        if (!has_begun) continue;
        since_last_mm += length(path);
        if (path.role == PathRole::Travel) continue;
        all_mm += since_last_mm;
        since_last_mm = 0.0;
      }
    const ToolpathMetrics metrics = measure(toolpath);
    RC_ASSERT(std::abs(metrics.material_mm + metrics.travel_mm - all_mm) <= 1e-9 * (1.0 + all_mm));
  }));
}

TEST(ToolpathMetrics, WhatIsNotAskedForIsNotANumber) {
  const ToolpathMetrics metrics = measure(straight({10.0}), onlyFor({"material_mm"}, {}));
  EXPECT_EQ(metrics.material_mm, 10.0);
  EXPECT_TRUE(std::isnan(metrics.under_fill_mm2));
  EXPECT_TRUE(std::isnan(metrics.control_energy_nm2_s));
  EXPECT_TRUE(onlyFor({"over_fill_mm2"}, {}).measures_surface);
  EXPECT_FALSE(onlyFor({"over_fill_mm2", "volume_error_mm3"}, {}).simulates_platform);
  for (const char* name : {"control_energy_nm2_s", "linear_ise_mm2_s", "rotational_ise_rad2_s"})
    EXPECT_TRUE(onlyFor({name}, {}).simulates_platform);
  EXPECT_THROW(onlyFor({"beauty"}, {}), InvalidConfig);
}

TEST(ToolpathMetrics, ValuesStandInTheOrderOfTheirNames) {
  const ToolpathMetrics metrics = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_EQ(metricValues(metrics), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(metricNames().size(), 9U);
  EXPECT_EQ(metricMeanings().size(), 9U);
  EXPECT_EQ(metricNames()[5], "volume_error_mm3");
}

TEST(ToolpathMetrics, ThePlatformHoldsItselfUpAndKeepsToALevelPath) {
  Toolpath square = straight({10.0});
  square.layers[0].paths[0].points = {{0, 0, 0.2}, {10, 0, 0.2}, {10, 10, 0.2}, {0, 10, 0.2}};
  MetricsSettings settings;
  settings.simulates_platform = true;
  const ToolpathMetrics metrics = measure(square, settings);
  // 1.5 to 5 (N m)2 hold it against gravity.
  EXPECT_GT(metrics.control_energy_nm2_s, 1.5 * metrics.print_time_s);
  EXPECT_LT(metrics.control_energy_nm2_s, 5.0 * metrics.print_time_s);
  EXPECT_GT(metrics.linear_ise_mm2_s, 0.0);
  EXPECT_LT(metrics.linear_ise_mm2_s, 1.0);
  EXPECT_LT(metrics.rotational_ise_rad2_s, 1e-6);
}

TEST(ToolpathMetrics, ThePlatformHasThePathInItsMiddle) {
  Toolpath far = straight({10.0});
  for (Point3& point : far.layers[0].paths[0].points) point += Point3(5000, 0, 0);
  MetricsSettings settings;
  settings.simulates_platform = true;
  EXPECT_GT(measure(far, settings).control_energy_nm2_s, 0.0);
  settings.platform.middle_mm.clear();
  EXPECT_THROW(measure(far, settings), Unreachable);
}

TEST(ToolpathMetrics, ThePlatformNeitherComesFromHomeNorParks) {
  const Path line = straight({10.0}).layers[0].paths[0];
  Path approach = test::straightPath({-5000, 0, 50}, line.firstPoint());
  Path parking = test::straightPath(line.lastPoint(), {0, 5000, 50});
  approach.role = parking.role = PathRole::Travel;
  approach.bead = parking.bead = Bead{0.0, 0.2};
  MetricsSettings settings;
  settings.simulates_platform = true;
  const Toolpath program{"program", {{0.2, 0.2, {approach, line, parking}}}};
  const ToolpathMetrics metrics = measure(program, settings);
  EXPECT_DOUBLE_EQ(metrics.control_energy_nm2_s, measure(straight({10.0}), settings).control_energy_nm2_s);
  EXPECT_EQ(metrics.travel_mm, 0.0);
}

TEST(ToolpathMetrics, ThoseAddedStandBehindTheNine) {
  Metric layers;
  layers.meaning = "Number of layers [1]";
  layers.measure = [](const MetricRequest& request) {
    return static_cast<double>(request.toolpath.layers.size());
  };
  const test::ScopedEntry<Metric> entry(toolpathMetrics(), "layers", layers);
  ASSERT_EQ(metricNames().size(), 10U);
  EXPECT_EQ(metricNames()[9], "layers");
  EXPECT_EQ(metricMeanings()[9], "Number of layers [1]");
  EXPECT_EQ(metricValues(measure(straight({10.0})))[9], 1.0);
  EXPECT_EQ(metricValues(measure(straight({10.0}), onlyFor({"layers"}, {})))[9], 1.0);
  EXPECT_TRUE(std::isnan(metricValues(measure(straight({10.0}), onlyFor({"travel_mm"}, {})))[9]));
}

TEST(ToolpathMetrics, AnAddedOneThatFailsIsNamed) {
  Metric broken;
  broken.measure = [](const MetricRequest&) -> double { throw InvalidInput("no layer"); };
  const test::ScopedEntry<Metric> entry(toolpathMetrics(), "broken", broken);
  try {
    measure(straight({10.0}));
    FAIL() << "nothing thrown";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "metric 'broken': no layer");
  }
}

}  // namespace
}  // namespace lamina
