// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lamina/program/five_axis/five_axis_settings.hpp"
#include "lamina/program/program_settings.hpp"
#include "program/five_axis/five_axis_letters.hpp"

namespace lamina {

/// One line's target and how it is reached.
struct FiveAxisTarget {
  JointValues joints;
  Point3 tip = Point3::Zero();  ///< [mm, bed]
  double filament_mm = 0.0;     ///< laid on the way
  double time_s = 0.0;
  double feed = 0.0;        ///< [mm/s], or [deg/s] in place
  const char* remark = "";  ///< " ;via" between two waypoints, " ;turn" in place
};

/// Writes the lines of a five-axis program; words that hold are left out.
class FiveAxisLines {
 public:
  FiveAxisLines(const KinematicModel& machine, const FiveAxisSettings& settings,
                const ProgramSettings& program);

  /// Rotary axes first, then tip control, then over the first waypoint and down.
  void approach(const JointValues& joints, const Point3& tip, const std::string& tip_control,
                std::string& text);
  void move(const FiveAxisTarget& target, std::string& text);
  /// Where the rotary joints of the line before are others than these, a turn in place.
  void turn(const JointValues& joints, std::string& text);
  /// Filament alone.
  void retract(double length_mm, std::string& text);
  void comment(const char* key, double value, std::string& text);

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  std::int64_t unitsOf(std::size_t axis, const JointValues& joints, const Point3& tip) const;
  std::string word(std::size_t axis, std::int64_t units) const;
  /// Words of the axes from `begin` to `end` that change.
  std::string changes(std::size_t begin, std::size_t end, const JointValues& joints, const Point3& tip);
  std::string feedWord(double per_minute);

  const KinematicModel& machine_;
  std::vector<AxisLetter> letters_;
  bool has_joints_;  ///< and inverse-time feed
  double retraction_feed_mm_s_;
  std::vector<std::int64_t> axes_;  ///< as written last
  std::int64_t feed_ = kUnknown;
  JointValues joints_;  ///< as of the line before
  Point3 tip_ = Point3::Zero();
  double filament_mm_ = 0.0;
  std::int64_t filament_ = 0;
  double waiting_s_ = 0.0;  ///< of motions too short to be written
};

}  // namespace lamina
