// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "lamina/control/layer_cells.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina::test {

/// A layer of parallel beads whose surface is known in closed form. `place(bead, way, across, error)` is the
/// point at a part of the way along a bead, so far beside its middle, so far below the planned top.
struct MeasuredLayer {
  std::string name;
  ToolpathLayer layer;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  std::size_t beads = 0;
  std::function<Point3(std::size_t, double, double, double)> place;
  std::function<Eigen::Vector3d(std::size_t, double)> growth;  ///< by bead and way
  std::function<Eigen::Vector3d(std::size_t, double)> across;
};

constexpr double kMeasuredCell = 0.5;
constexpr double kMeasuredLength = 40.0;  // of straight beads
constexpr double kMeasuredRadius = 50.0;  // of the sphere

inline Path measuredBead(const Bead& bead) {
  Path path;
  path.role = PathRole::Infill;
  path.bead = bead;
  path.feed_mm_s = 10.0;
  return path;
}

/// Straight beads in a plane that is turned about x.
inline MeasuredLayer inclinedLayer(double angle_deg, std::size_t beads, const Bead& bead,
                                   std::size_t number = 0) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle_deg * M_PI / 180.0, Eigen::Vector3d::UnitX()));
  const double z = static_cast<double>(number + 1) * bead.height_mm;
  MeasuredLayer measured;
  measured.name = std::to_string(int(angle_deg)) + " degrees";
  measured.normal = turn * Eigen::Vector3d::UnitZ();
  measured.beads = beads;
  measured.layer = {z, bead.height_mm, {}};
  const double pitch = bead.width_mm;
  measured.place = [=](std::size_t at, double way, double across, double error) {
    return Point3(turn * Point3(way * kMeasuredLength, static_cast<double>(at) * pitch + across, z - error));
  };
  measured.growth = [=](std::size_t, double) { return Eigen::Vector3d(turn * Eigen::Vector3d::UnitZ()); };
  measured.across = [=](std::size_t, double) { return Eigen::Vector3d(turn * Eigen::Vector3d::UnitY()); };
  for (std::size_t i = 0; i < beads; ++i) {
    Path path = measuredBead(bead);
    path.points = {measured.place(i, 0.0, 0.0, 0.0), measured.place(i, 1.0, 0.0, 0.0)};
    measured.layer.paths.push_back(path);
  }
  return measured;
}

/// Closed rings about z on a sphere, from so many degrees off its pole on, the nozzle square to it. Waypoints
/// lie on the middles and borders of cells.
inline MeasuredLayer sphericalLayer(std::size_t rings, const Bead& bead, std::size_t number = 0,
                                    double from_deg = 20.0) {
  const double radius = kMeasuredRadius + static_cast<double>(number) * bead.height_mm;
  const auto polar = [=](std::size_t at) {
    return from_deg * M_PI / 180.0 + static_cast<double>(at) * bead.width_mm / kMeasuredRadius;
  };
  const auto direction = [](double theta, double phi) {
    return Eigen::Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  MeasuredLayer measured;
  measured.name = "sphere";
  measured.beads = rings;
  measured.layer = {radius, bead.height_mm, {}};
  measured.place = [=](std::size_t at, double way, double across, double error) {
    // Seen against growth, the left of a ring that goes round the pole anticlockwise is towards the pole.
    return Point3((radius - error) * direction(polar(at) - across / radius, 2.0 * M_PI * way));
  };
  measured.growth = [=](std::size_t at, double way) { return direction(polar(at), 2.0 * M_PI * way); };
  measured.across = [=](std::size_t at, double way) {
    return Eigen::Vector3d(-direction(polar(at) + 0.5 * M_PI, 2.0 * M_PI * way));
  };
  for (std::size_t i = 0; i < rings; ++i) {
    Path path = measuredBead(bead);
    path.is_closed = true;
    const double around = 2.0 * M_PI * radius * std::sin(polar(i));
    const auto cells = static_cast<std::size_t>(std::ceil(around / kMeasuredCell));
    std::vector<Eigen::Quaterniond> held;
    for (std::size_t k = 0; k < 2 * cells; ++k) {
      const double way = static_cast<double>(k) / static_cast<double>(2 * cells);
      path.points.push_back(measured.place(i, way, 0.0, 0.0));
      held.push_back(shortestRotation(Eigen::Vector3d::UnitZ(), -measured.growth(i, way)));
    }
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(held));
    measured.layer.paths.push_back(path);
  }
  return measured;
}

/// Level, at 30 and 45 degrees, and on a sphere.
inline std::vector<MeasuredLayer> measuredLayers(std::size_t beads, const Bead& bead) {
  return {inclinedLayer(0.0, beads, bead), inclinedLayer(30.0, beads, bead), inclinedLayer(45.0, beads, bead),
          sphericalLayer(beads, bead)};
}

inline LayerCells cellsOf(const MeasuredLayer& measured, std::size_t number = 0) {
  return layerCells(measured.layer, number, kMeasuredCell, measured.normal);
}

/// A sensor 60 mm above a place of the layer, its line across the beads.
inline Eigen::Isometry3d sensorOver(const MeasuredLayer& measured, std::size_t bead, double way) {
  const Eigen::Vector3d view = -measured.growth(bead, way);
  const Eigen::Vector3d line = measured.across(bead, way);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << line, view.cross(line), view;
  pose.translation() = measured.place(bead, way, 0.0, 0.0) - 60.0 * view;
  return pose;
}

}  // namespace lamina::test
