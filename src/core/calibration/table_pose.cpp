// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "table_pose.hpp"

#include <cmath>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kUnitLength = 0.01;  // of a quaternion, by which it may be off

}  // namespace

Eigen::Vector3d tablePoint(const RecordingTable& table, std::size_t row, const std::string& prefix) {
  const auto cell = [&](const char* name) { return table.at(row, requireColumn(table, prefix + name)); };
  return {cell("x_mm"), cell("y_mm"), cell("z_mm")};
}

Eigen::Isometry3d tablePose(const RecordingTable& table, std::size_t row, const std::string& prefix) {
  const auto cell = [&](const char* name) { return table.at(row, requireColumn(table, prefix + name)); };
  const Eigen::Quaterniond turn(cell("qw"), cell("qx"), cell("qy"), cell("qz"));
  if (!(std::abs(turn.norm() - 1.0) < kUnitLength))
    throw InvalidInput("'" + table.source + "' line " + std::to_string(table.lines[row]) +
                       ": a quaternion's length is " + numberText(turn.norm()) + "; expected 1");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() = tablePoint(table, row, prefix);
  return pose;
}

Eigen::Isometry3d poseByAngles(const RecordingTable& table, std::size_t row) {
  const auto about = [&](const char* name, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(toRadians(table.at(row, requireColumn(table, name))), axis);
  };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (about("rz_deg", Eigen::Vector3d::UnitZ()) * about("ry_deg", Eigen::Vector3d::UnitY()) *
                   about("rx_deg", Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = tablePoint(table, row, "");
  return pose;
}

}  // namespace lamina
