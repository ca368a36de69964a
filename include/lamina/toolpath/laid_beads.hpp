// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// Where the place at which a nozzle came to rest is looked for.
struct LaidSearch {
  double reported_mm = 0.0;                                   ///< length of the beads reported last as laid
  double behind_mm = 0.0;                                     ///< by which the machine may trail the report
  double ahead_mm = std::numeric_limits<double>::infinity();  ///< by which it may have gone beyond the report
  /// Greatest height of the place above or below the reported one, along the tool axis [mm]: a lifted tool
  /// may stand on a later layer.
  double most_rise_mm = std::numeric_limits<double>::infinity();
  double tolerance_mm = 0.5;  ///< of the nozzle from the toolpath
};

/// Places of a toolpath by the length of the beads that are laid up to there [mm]. Travels have none: at the
/// length at which a bead ends, the place is the start of the next one.
class LaidBeads {
 public:
  explicit LaidBeads(const Toolpath& toolpath);

  double total() const { return laid_.empty() ? 0.0 : laid_.back(); }
  /// What is laid once a waypoint is reached; waypoint 0 of a closed path at its start.
  /// @throws InvalidInput if the toolpath has no such waypoint
  double before(const WaypointIndex& waypoint) const;
  /// Volume of the beads up to a length, as planned [mm³].
  double volume(double length_mm) const;
  /// The length at which the bead begins that goes on at a length: motions that are laid without a break are
  /// one bead.
  double beadStart(double length_mm) const;
  /// The waypoint that the nozzle goes to at a length; the last one of all where everything is laid.
  WaypointIndex headingFor(double length_mm) const;

  /// The length that is laid where the nozzle stands: at the nearest place of the toolpath within the search.
  /// Nothing if no place is within the tolerance, if another place, a millimetre or more of bead away, is
  /// less than twice as far (plus 0.02 mm), or if the tool axis leans by more than `kAxisTolerance` from that
  /// of the motion.
  /// @param nozzle  its pose in the part frame [mm]
  std::optional<double> find(const Eigen::Isometry3d& nozzle, const LaidSearch& search) const;

  /// Greatest feed of the beads [mm/s]; 0 without beads.
  double greatestFeed() const { return greatest_feed_mm_s_; }

  static constexpr double kAxisTolerance = 0.05;  ///< [rad]

 private:
  struct Motion {
    WaypointIndex end;  ///< waypoint 0 of a closed path if it ends there
    Point3 from, to;
    Point3 axis_from, axis_to;  ///< of the tool, units
    double area_mm2 = 0.0;      ///< of what it lays; 0 on a travel
  };
  struct Candidate {
    double laid_mm = 0.0;
    double off_mm = 0.0;  ///< of the nozzle
  };
  std::size_t motionAt(double length_mm) const;
  std::vector<Candidate> candidates(const Eigen::Isometry3d& nozzle, const LaidSearch& search) const;

  std::vector<Motion> motions_;
  std::vector<double> laid_;  ///< at the end of each motion
  double greatest_feed_mm_s_ = 0.0;
};

}  // namespace lamina
