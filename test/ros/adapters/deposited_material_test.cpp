// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/simulated_controller/deposited_material.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kLength = 30.0;     // mm: beads go from 0 to that along x, at y 0
constexpr double kLayer = 1.5;       // mm
constexpr double kBeadWidth = 3.0;   // mm
constexpr double kBeadSpeed = 30.0;  // mm/s

ControllerSettings wallSettings() {
  ControllerSettings settings;
  settings.deposit_area_mm = {-10.0, -10.0, 40.0, 10.0};
  settings.grown.bead_width_mm = kBeadWidth;
  return settings;
}

/// Reports of a nozzle that lays beads one above the other and goes back without a flow.
DepositedMaterial wallBy(const ControllerSettings& settings, int layers, double report_s = 0.02) {
  DepositedMaterial deposited(settings);
  double time_s = 0.0;
  for (int layer = 1; layer <= layers; ++layer) {
    const double z = kLayer * layer;
    const double flow = kBeadSpeed * kBeadWidth * kLayer;
    deposited.observe({time_s, {0, 0, z}, 0.0});
    deposited.observe({time_s, {0, 0, z}, flow});
    const int steps = static_cast<int>(std::lround(kLength / kBeadSpeed / report_s));
    for (int i = 1; i <= steps; ++i)
      deposited.observe({time_s + i * report_s, {kLength * i / steps, 0, z}, flow});
    time_s += kLength / kBeadSpeed;
    deposited.observe({time_s, {kLength, 0, z}, 0.0});
    time_s += 1.0;
    deposited.observe({time_s, {0, 0, z + 5.0}, 0.0});
  }
  return deposited;
}

double heightAt(const DepositedMaterial& deposited, double x, double y = 0.0) {
  const HeightMap& surface = deposited.surface();
  return surface.at(surface.grid().cellAt({x, y}));
}

TEST(DepositedMaterial, IsWhatFlowsWhereTheNozzleIs) {
  const DepositedMaterial deposited = wallBy(wallSettings(), 3);
  for (const double x : {1.0, 10.0, 29.0}) EXPECT_NEAR(heightAt(deposited, x), 3 * kLayer, 1e-9) << x;
  EXPECT_EQ(heightAt(deposited, 15.0, 2.0), 0.0) << "beside the wall";
  EXPECT_EQ(heightAt(deposited, -2.0), 0.0) << "in front of it";
}

TEST(DepositedMaterial, DoesNotDependOnHowOftenItIsReported) {
  const DepositedMaterial often = wallBy(wallSettings(), 2, 0.005);
  const DepositedMaterial seldom = wallBy(wallSettings(), 2, 0.05);
  for (double x = 0.5; x < kLength; x += 0.5) EXPECT_NEAR(heightAt(often, x), heightAt(seldom, x), 1e-9);
}

TEST(DepositedMaterial, GrowsAsTheProcessDoes) {
  ControllerSettings settings = wallSettings();
  settings.plant.gain = 0.8;
  EXPECT_NEAR(heightAt(wallBy(settings, 2), 15.0), 0.8 * 2 * kLayer, 1e-9);
  settings.plant = {};
  settings.plant.wear = 0.5;
  settings.grown.layers = 2;
  EXPECT_NEAR(heightAt(wallBy(settings, 2), 15.0), (1.0 + 0.75) * kLayer, 1e-9) << "deposit.layers";
  settings = wallSettings();
  settings.grown.bead_width_mm = 2.0 * kBeadWidth;
  EXPECT_NEAR(heightAt(wallBy(settings, 1), 15.0), 0.5 * kLayer, 1e-9) << "deposit.bead_width_mm";
  settings.grown.bead_width_mm = 0.0;
  EXPECT_NEAR(heightAt(wallBy(settings, 1), 15.0), kLayer, 1e-9) << "that of the first bead";
}

TEST(DepositedMaterial, IsSeenByItsSensor) {
  ControllerSettings settings = wallSettings();
  settings.sensor.noise_mm = 0.0;
  DepositedMaterial deposited = wallBy(settings, 2);
  Eigen::Isometry3d bed_from_sensor = Eigen::Isometry3d::Identity();
  bed_from_sensor.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  bed_from_sensor.translation() = Point3(15, 0, 65);
  const std::vector<Point3> points = deposited.seenFrom(bed_from_sensor, 0.0);
  ASSERT_GT(points.size(), 100U);
  for (const Point3& point : points) {
    const Point3 on_bed = bed_from_sensor * point;
    if (on_bed.x() < 1.0 || on_bed.x() > 29.0) continue;
    EXPECT_NEAR(on_bed.z(), 2 * kLayer, 1e-6);
  }
  EXPECT_EQ(deposited.stampError(), 0.0);
}

TEST(DepositedMaterial, RefusesAnAreaThatIsNone) {
  for (const auto& area : {std::vector<double>{0, 0, 0, 10}, std::vector<double>{0, 10, 10, 0}}) {
    ControllerSettings settings = wallSettings();
    settings.deposit_area_mm = area;
    EXPECT_THROW(DepositedMaterial{settings}, InvalidConfig);
  }
  ControllerSettings settings = wallSettings();
  settings.deposit_area_mm = {0, 0, 1e5, 1e5};
  try {
    const DepositedMaterial material(settings);
    FAIL() << "expected to be refused";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("deposit.cell_mm"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
