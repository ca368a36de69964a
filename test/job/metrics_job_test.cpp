// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/metrics_job.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "lamina/base/error.hpp"
#include "support/scoped_entry.hpp"

namespace lamina {
namespace {

SliceMeasurement ofATetradecahedron() {
  return SliceMeasurement({"tetradecahedron", "", loadJobSettings("", {{"walls.count", "1"}})});
}

std::vector<double> measure(const SliceMeasurement& measurement, const std::vector<SettingText>& overrides,
                            const std::vector<std::string>& metrics) {
  NoProgress nobody;
  return measurement.measure(overrides, metrics, nobody);
}

TEST(SliceMeasurement, IsThatOfTheSlicedPart) {
  const std::vector<SettingText> overrides = {{"infill.density", "0.5"}, {"walls.count", "2"}};
  NoProgress nobody;
  const SlicedPart sliced = runSliceJob({"tetradecahedron", "", loadJobSettings("", overrides)}, nobody);
  const auto values =
      measure(ofATetradecahedron(), overrides, {"travel_mm", "material_mm", "under_fill_mm2"});
  ASSERT_EQ(values.size(), 3U);
  EXPECT_NEAR(values[0], sliced.summary.travel_mm, 1e-6);
  EXPECT_NEAR(values[1], sliced.summary.deposition_mm, 1e-6);
  EXPECT_GT(values[2], 0.0);
}

TEST(SliceMeasurement, MayBeAskedBySeveralThreads) {
  const SliceMeasurement measurement = ofATetradecahedron();
  std::vector<std::vector<double>> values(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& each : values)
    threads.emplace_back([&] {
      each = measure(measurement, {{"infill.density", "0.3"}}, {"volume_error_mm3", "under_fill_mm2"});
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& each : values) EXPECT_EQ(each, values[0]);
}

TEST(SliceMeasurement, RefusesWhatItCannotChangeOrMeasure) {
  const SliceMeasurement measurement = ofATetradecahedron();
  EXPECT_THROW(measure(measurement, {{"input.scale", "2"}}, {"travel_mm"}), InvalidConfig);
  EXPECT_THROW(measure(measurement, {{"infill.densty", "0.2"}}, {"travel_mm"}), InvalidConfig);
  EXPECT_THROW(measure(measurement, {{"infill.density", "2"}}, {"travel_mm"}), InvalidConfig);
  EXPECT_THROW(measure(measurement, {}, {"beauty"}), InvalidConfig);
  EXPECT_THROW(SliceMeasurement({"no_such_part.stl", "", {}}), FileError);
}

/// What shrinks by a fifth is printed 1.25 times as large.
TEST(SliceMeasurement, ComparesAPartThatShrinksAsItIsPrinted) {
  const SliceMeasurement large(
      {"tetradecahedron", "", loadJobSettings("", {{"walls.count", "1"}, {"input.scale", "1.25"}})});
  const std::vector<SettingText> shrinks = {{"compensation.shrink_xy", "0.2"},
                                            {"compensation.shrink_z", "0.2"}};
  const double error_mm3 = measure(large, {}, {"volume_error_mm3"})[0];
  EXPECT_NEAR(measure(ofATetradecahedron(), shrinks, {"volume_error_mm3"})[0], error_mm3,
              1e-3 * std::abs(error_mm3));
}

TEST(SliceMeasurement, TakesAMetricThatWasAdded) {
  Metric layers;
  layers.measure = [](const MetricRequest& request) {
    return static_cast<double>(request.toolpath.layers.size());
  };
  const test::ScopedEntry<Metric> entry(toolpathMetrics(), "layers", layers);
  NoProgress nobody;
  const SlicedPart sliced =
      runSliceJob({"tetradecahedron", "", loadJobSettings("", {{"walls.count", "1"}})}, nobody);
  EXPECT_EQ(measure(ofATetradecahedron(), {}, {"layers"}),
            (std::vector<double>{static_cast<double>(sliced.summary.layers)}));
}

}  // namespace
}  // namespace lamina
