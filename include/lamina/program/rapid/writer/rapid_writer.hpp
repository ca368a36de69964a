// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "lamina/program/rapid/rapid_settings.hpp"
#include "lamina/program/robot/robot_motion.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath as a program in RAPID [Flores2018, section 6.1.3]: one module, or a main module and numbered
/// modules with the points.
///
/// Each point has two lines, a move and a line for the process, which is empty if the process continues; so
/// point k is on line 2k-1 of its procedure. Paths that deposit are runs with the laser (and wire) on;
/// consecutive paths that meet in one pose form one run. Travels are air moves. Points where the process
/// starts or ends have the zone `end_zone`, all others `zone`. Positions are relative to the work object,
/// which is the bed [mm, 4 decimals]: offsets from the start point with 3 axes, targets with 5, whose
/// orientation (w x y z, 7 decimals) is bed_from_nozzle. Comments before each procedure state roles, beads
/// and layers.
///
/// The constructor checks everything; writing takes linear time and constant memory. The toolpath, and the
/// robot's motion, must outlive the program.
class RapidProgram {
 public:
  /// @param bed_from_part  pose of the part on the bed [mm]
  /// @param robot  its arm and joints, for `RapidConfiguration::Joints` and for external axes; may be null
  /// @throws InvalidInput, naming layer, path and waypoint: if the toolpath holds no motion, or holds drops,
  ///   process values or events other than dwells; if a position is farther than 100 m, a feed is below 0.001
  ///   mm/s or an orientation is not of unit length; if the nozzle would have to rotate in a variant of 3
  ///   axes; if the joints are not those of the toolpath
  /// @throws Unreachable  if the joints have faults (names the first), or the arm cannot reach where the
  ///   program starts or ends, `rapid.approach_mm` off the part
  /// @throws InvalidConfig as `checkedRapidSettings`; if the name of a predefined speed of RAPID is used for
  ///   another feed; if a run is longer than a module that is loaded in turn; if configurations are asked for
  ///   without joints
  RapidProgram(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
               const RapidSettings& settings, const RobotMotion* robot = nullptr);
  ~RapidProgram();
  RapidProgram(RapidProgram&&) noexcept;
  RapidProgram& operator=(RapidProgram&&) noexcept;

  /// Names of the modules, the module with `main` first. The file of a module has its name and the suffix
  /// .mod.
  const std::vector<std::string>& moduleNames() const;
  /// Writes a module, by its index in `moduleNames`.
  void write(std::size_t module, const TextSink& sink) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Writes a program of one module.
/// @throws InvalidConfig also if the program has several modules
void writeRapid(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                const RapidSettings& settings, const TextSink& sink, const RobotMotion* robot = nullptr);

/// A note for the summary if a module states a default load of the tool, as nothing else gives one; empty
/// otherwise.
std::string rapidLoadNote(const RapidSettings& settings, const RobotMotion* robot);

}  // namespace lamina
