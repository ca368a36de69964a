// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "program/program_stations.hpp"
#include "program/rapid/writer/rapid_plan.hpp"
#include "program/rapid/writer/rapid_speeds.hpp"
#include "program/rapid/writer/rapid_wire_stops.hpp"

namespace lamina {

/// Configuration of the settings: `[-1,0,0,2]`.
std::string rapidConfiguration(const RapidSettings& settings);

/// External axes with these values [mm, deg] first, and 9e+09, not in use, for the rest. Without values the
/// first external axis is that of the settings, if they have one: `[0.000,9e+09,9e+09,9e+09,9e+09,9e+09]`.
std::string rapidExternalAxes(std::vector<double> values, const RapidSettings& settings);

/// Configuration of joint values: `[0,-1,0,1]`.
std::string rapidConfiguration(const AbbConfiguration& configuration);

/// Pose in the work object [mm] as the beginning of a robtarget, `[[x,y,z],[w,x,y,z]`, without its closing
/// bracket.
std::string rapidPose(const Point3& point, const Eigen::Quaterniond& turn);

/// Position as an offset from the start point [mm]: `Offs(START,off_x+1.0000,...)`.
std::string rapidOffset(const Point3& point, const RapidSettings& settings);

/// Writes the two lines for each point of a program.
class RapidLines {
 public:
  /// The plan must be that of the toolpath; all arguments must outlive the object.
  RapidLines(const Toolpath& toolpath, const RapidPlan& plan, const RapidSpeeds& speeds,
             const Eigen::Isometry3d& bed_from_part, const RapidSettings& settings);

  /// Makes all further targets state configuration and external axes of the arm. Both arguments must outlive
  /// the object.
  void setRobot(const KinematicModel& arm, const ProgramStations& stations);

  void append(const RapidPlace& place, std::string& text) const;

 private:
  bool isLastMove(const RapidPlace& place) const;
  bool startsAfter(const RapidPlace& place) const;
  bool isRunEnd(const RapidPlace& place) const;
  bool isFine(const RapidPlace& place) const;
  void appendTarget(const RapidPlace& place, std::size_t waypoint, std::string& text) const;
  void appendAxes(const RapidPlace& place, std::string& text) const;
  void appendTail(const RapidPlace& place, const std::string& speed, std::string& text) const;

  bool isArc(const RapidPlace& place) const;
  const char* instruction(const RapidPlace& place) const;
  const RapidWireStop* wireStopOn(const RapidPlace& place) const;
  void appendProcess(const RapidPlace& place, std::string& text) const;
  RapidPlace placeAfter(const RapidPlace& place) const;
  bool isBead(const RapidPlace& place) const;
  std::optional<double> levelOn(const RapidPlace& place, const RapidLevel& level) const;
  std::optional<double> levelBefore(const RapidPlace& place, const RapidLevel& level) const;
  std::optional<double> changedLevel(const RapidPlace& place, const RapidLevel& level) const;
  std::vector<std::string> triggersOn(const RapidPlace& place) const;
  void appendLevels(const RapidPlace& place, std::string& text) const;
  std::string levelAtRest(const RapidLevel& level, const std::string& number) const;
  std::string levelOnTheWay(std::size_t level, const std::string& number) const;
  bool isKeptDry(const std::string& number) const;

  const Toolpath& toolpath_;
  const RapidPlan& plan_;
  const RapidSpeeds& speeds_;
  Eigen::Isometry3d bed_from_part_;
  Eigen::Quaterniond turn_;  ///< bed_from_part
  RapidSettings settings_;
  std::vector<RapidLevel> levels_;
  std::string tail_;  ///< tool and work object
  std::string fixed_axes_;
  std::string arc_;  ///< arguments of arc moves
  std::string on_;
  std::string off_;
  std::vector<RapidWireStop> wire_stops_;  ///< in the order of their moves
  const KinematicModel* arm_ = nullptr;
  const ProgramStations* stations_ = nullptr;
};

}  // namespace lamina
