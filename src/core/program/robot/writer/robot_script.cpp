// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/writer/robot_script.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/process_support.hpp"
#include "program/backed_off.hpp"
#include "program/cell_frame.hpp"
#include "program/robot/notes/robot_notes.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

JointValues joinedJoints(const KinematicModel& arm, const JointValues& near, double way_mm,
                         const std::string& where) {
  if (way_mm == 0.0) return near;
  const auto joints = followingJoints(arm, backedOff(arm.bedFromNozzle(near), way_mm), near);
  const std::optional<std::string> fault = joints ? limitFault(*joints, arm) : "out of reach";
  if (fault)
    throw Unreachable("'" + arm.name() + "' cannot stand " + numberText(way_mm) +
                      " mm (robot_program.approach_mm) back from the " + where +
                      " waypoint along the tool axis: " + *fault);
  return *joints;
}

void requireLevels(const Toolpath& toolpath, const std::vector<RobotLevel>& levels) {
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      for (const ProcessValue& value : toolpath.layers[l].paths[p].values)
        if (std::none_of(levels.begin(), levels.end(),
                         [&](const RobotLevel& level) { return level.name == value.name; }))
          throw InvalidInput("toolpath layer " + std::to_string(l) + ", path " + std::to_string(p) +
                             ": states the process value '" + value.name +
                             "'; expected an output for it in robot_program.levels");
}

std::string number(double value) { return shortestText(value == 0.0 ? 0.0 : value); }

/// Two loads of one tool: what a controller is told would differ from what the cell is checked with.
void requireLoadOfCell(const RobotProgramSettings& settings, const ToolLoad& load) {
  if (settings.tool_mass_kg == 0.0) return;
  const std::vector<double>& set = settings.tool_centre_of_gravity_mm;
  const Point3 centre(set[0], set[1], set[2]);
  if (isSameLoad({settings.tool_mass_kg, centre}, load)) return;
  throw InvalidConfig("robot_program.tool_mass_kg and tool_centre_of_gravity_mm are " +
                      shownLoad({settings.tool_mass_kg, centre}) + "; expected 0, or " + shownLoad(load) +
                      ", that of the cell file's tool");
}

}  // namespace

RobotScript::RobotScript(const RobotJob& job, const RobotProgramSettings& settings, const ControllerMap& map)
    : job_(job),
      settings_(settings),
      map_(map),
      levels_(robotLevels(settings.levels)),
      turn_(job.bed_from_part.linear()) {
  requireConsistent(settings);
  requireSupported(job.toolpath, {ProcessElement::Value, ProcessElement::Dwell}, "a robot's program");
  requireLevels(job.toolpath, levels_);
  paths_ = robotPaths(job.toolpath, ToolTurns::Any);
  stretches_ = robotStretches(paths_);
  if (job.robot == nullptr) return;
  stations_.emplace(job.toolpath, job.bed_from_part, job.robot->arm, job.robot->joints);
  cell_ = controllerCell(job.robot->arm);
  if (!cell_->load) return;
  const Point3& centre = cell_->load->centre_mm;
  requireLoadOfCell(settings_, *cell_->load);
  settings_.tool_mass_kg = cell_->load->mass_kg;
  // What turning the flange leaves of a centre is not written.
  const auto rounded = [](double value_mm) { return std::round(value_mm * 1e4) / 1e4 + 0.0; };
  settings_.tool_centre_of_gravity_mm = {rounded(centre.x()), rounded(centre.y()), rounded(centre.z())};
}

std::vector<JointKind> RobotScript::externalKinds() const {
  return job_.robot == nullptr ? std::vector<JointKind>() : controllerAxisKinds(map_, job_.robot->arm);
}

std::vector<std::string> RobotScript::headNotes() const {
  std::vector<std::string> notes;
  if (cell_) {
    notes.push_back(frameNote("tool", cell_->flange_from_nozzle));
    notes.push_back(frameNote(cell_->is_bed_carried ? "carried_bed" : "bed", cell_->carrier_from_bed));
  }
  if (settings_.tool_mass_kg > 0.0) {
    std::string text = std::string(kLoadNote) + " " + number(settings_.tool_mass_kg);
    for (const double each : settings_.tool_centre_of_gravity_mm) text += " " + number(each);
    notes.push_back(std::move(text));
  }
  if (settings_.arc.process == RobotProcess::Outputs)
    notes.push_back("process " + std::to_string(settings_.process_output));
  if (settings_.dry_flag > 0)
    notes.push_back(std::string(kDryFlagNote) + " " + std::to_string(settings_.dry_flag));
  if (settings_.dry_speed_percent < 100.0)
    notes.push_back(std::string(kDrySpeedNote) + " " + number(settings_.dry_speed_percent));
  for (const RobotLevel& level : levels_)
    notes.push_back("level " + level.name + " " + std::to_string(level.output) + " " + number(level.per));
  if (cell_ && !map_.isPlain()) {
    std::string text = "joints";
    for (const double sign : map_.signs) text += " " + number(sign);
    for (const double zero : map_.zeros_deg) text += " " + number(zero);
    notes.push_back(text + " " + number(map_.joint_3_from_2));
  }
  for (const ExternalEntry& entry : map_.external)
    if (cell_)
      notes.push_back(std::string(kExternalNote) + " " + entry.joint + " " + number(entry.sign) + " " +
                      number(entry.zero));
  const Eigen::Quaterniond layers = turn_ * job_.toolpath.part_from_layers;
  if (layers.angularDistance(Eigen::Quaterniond::Identity()) > 0.0)
    notes.push_back("layers " + number(layers.w()) + " " + number(layers.x()) + " " + number(layers.y()) +
                    " " + number(layers.z()));
  return notes;
}

std::string RobotScript::place(const RobotStretch& stretch) const {
  const RobotPath& path = paths_[stretch.begin];
  return "layer " + std::to_string(path.layer) + ", path " + std::to_string(path.index);
}

const JointValues* RobotScript::jointsAt(std::size_t path, std::size_t move) const {
  if (!stations_) return nullptr;
  const std::size_t turns = paths_[path].turnCount();
  return move < turns ? &stations_->begin(path) : &stations_->end(path, move - turns);
}

std::optional<ArmPosture> RobotScript::postureOf(const JointValues* joints) const {
  if (joints == nullptr) return std::nullopt;
  const KinematicModel& arm = job_.robot->arm;
  return ArmPosture{controllerJoints(map_, arm, *joints), abbConfiguration(arm, *joints).cfx};
}

std::optional<ArmPosture> RobotScript::postureAtStart(const RobotStretch& stretch) const {
  return stations_ ? postureOf(&stations_->begin(stretch.begin)) : std::nullopt;
}

TipMove RobotScript::passage(const Eigen::Isometry3d& pose, const JointValues& joints) const {
  TipMove move;
  move.point = pose.translation();
  move.orientation = Eigen::Quaterniond(pose.linear()).normalized();
  move.external = controllerAxes(map_, job_.robot->arm, joints);
  move.posture = postureOf(&joints);
  move.feed_mm_s = feedOfApproach();
  move.rests = true;
  return move;
}

JointMove RobotScript::jointMove(const JointValues& joints) const {
  TipMove pose = passage(job_.robot->arm.bedFromNozzle(joints), joints);
  ControllerJoints stated = pose.posture->joints;
  return {std::move(stated), std::move(pose)};
}

JointMove RobotScript::jointMoveTo(const ArmPosture& posture) const {
  return jointMove(armJoints(map_, job_.robot->arm, posture.joints));
}

std::vector<RobotStatement> RobotScript::approach() const {
  if (!stations_) return {};
  const JointValues start =
      joinedJoints(job_.robot->arm, stations_->begin(0), settings_.approach_mm, "first");
  return {NoteLine{std::string(kApproachNote)}, jointMove(start)};
}

std::vector<RobotStatement> RobotScript::retract() const {
  if (!stations_ || settings_.approach_mm == 0.0) return {};
  const std::size_t last = paths_.size() - 1;
  const JointValues& end = *jointsAt(last, paths_[last].moveCount() - 1);
  const JointValues back = joinedJoints(job_.robot->arm, end, settings_.approach_mm, "last");
  const Eigen::Isometry3d pose = backedOff(job_.robot->arm.bedFromNozzle(end), settings_.approach_mm);
  return {NoteLine{std::string(kRetractNote)}, passage(pose, back)};
}

std::vector<RobotStatement> RobotScript::retractFrom(const ArmPosture& posture) const {
  if (!stations_ || settings_.approach_mm == 0.0) return {};
  const KinematicModel& arm = job_.robot->arm;
  const JointValues end = armJoints(map_, arm, posture.joints);
  const JointValues back = joinedJoints(arm, end, settings_.approach_mm, "last of a file's");
  return {NoteLine{std::string(kRetractNote)}, passage(arm.bedFromNozzle(back), back)};
}

std::vector<RobotStatement> RobotScript::approachTo(const ArmPosture& posture) const {
  const NoteLine note{std::string(kApproachNote)};
  if (settings_.approach_mm == 0.0) return {note, jointMoveTo(posture)};
  const KinematicModel& arm = job_.robot->arm;
  const JointValues start = armJoints(map_, arm, posture.joints);
  const JointValues back = joinedJoints(arm, start, settings_.approach_mm, "first of a file's");
  return {note, jointMove(back), note, passage(arm.bedFromNozzle(start), start)};
}

/// That of the first travel, or of the first path if there is none.
double RobotScript::feedOfApproach() const {
  for (const RobotPath& path : paths_)
    if (!path.deposits()) return path.path->feed_mm_s.at(path.path->motionEnd(0));
  return paths_.front().path->feed_mm_s.at(paths_.front().path->motionEnd(0));
}

bool RobotScript::restsAfter(std::size_t index, std::size_t move) const {
  const RobotPath& path = paths_[index];
  if (path.is_turned && move == 0) return true;
  if (dwellAfter(job_.toolpath, paths_, index, move) > 0.0) return true;
  if (move + 1 < path.moveCount()) return false;
  if (index + 1 == paths_.size() || path.switches_off) return true;
  return paths_[index + 1].is_turned || paths_[index + 1].switches_on;
}

TipMove RobotScript::moveTo(std::size_t index, std::size_t move) const {
  const RobotPath& path = paths_[index];
  const bool is_turn = path.is_turned && move == 0;
  const std::size_t motion = move - (is_turn ? 0 : path.turnCount());
  const std::size_t waypoint = is_turn ? 0 : path.path->motionEnd(motion);
  TipMove result;
  result.point = job_.bed_from_part * path.path->points[waypoint];
  result.orientation = (turn_ * path.path->orientation.at(waypoint)).normalized();
  result.rests = restsAfter(index, move);
  result.lays = path.deposits() && !is_turn;
  result.feed_mm_s = is_turn ? feedOfApproach() : path.path->feed_mm_s.at(waypoint);
  result.moves_left = path.moveCount() - move;
  if (const JointValues* joints = jointsAt(index, move)) {
    result.external = controllerAxes(map_, job_.robot->arm, *joints);
    result.posture = postureOf(joints);
  }
  if (!result.rests) {
    const Path& after = motion + 1 < path.path->motionCount() ? *path.path : *paths_[index + 1].path;
    result.room_mm =
        std::min(motionLength(*path.path, motion), motionLength(after, &after == path.path ? motion + 1 : 0));
  }
  return result;
}

/// Puts the statements of a stretch one after the other.
class RobotScript::Stretch {
 public:
  Stretch(const RobotScript& script, double rise_mm)
      : script_(script), rise_mm_(rise_mm), stated_(script.levels_.size(), kUnset) {}

  void addPath(std::size_t index) {
    const RobotPath& path = script_.paths_[index];
    const bool begins_layer = index == 0 || script_.paths_[index - 1].layer != path.layer;
    for (std::string& note : pathNotes(script_.job_.toolpath, path, begins_layer, rise_mm_))
      statements_.emplace_back(NoteLine{std::move(note)});
    for (std::size_t move = 0; move < path.moveCount(); ++move) {
      const bool is_turn = path.is_turned && move == 0;
      if (path.deposits() && !is_turn) addLevels(*path.path, path.path->motionEnd(move - path.turnCount()));
      if (path.switches_on && move == path.turnCount()) addStart();
      TipMove to = script_.moveTo(index, move);
      rests_ = to.rests;
      statements_.emplace_back(std::move(to));
      if (path.switches_off && move + 1 == path.moveCount()) addEnd();
      addDwell(index, move);
    }
  }

  std::vector<RobotStatement> take() { return std::move(statements_); }

 private:
  /// Those that the motion to the waypoint asks for, if they are others than before.
  void addLevels(const Path& path, std::size_t waypoint) {
    for (std::size_t k = 0; k < stated_.size(); ++k)
      for (const ProcessValue& value : path.values) {
        if (value.name != script_.levels_[k].name) continue;
        const double level = script_.levels_[k].per * value.value.at(waypoint);
        if (level == stated_[k]) continue;
        stated_[k] = level;
        statements_.emplace_back(LevelChange{script_.levels_[k].output, level, !rests_});
      }
  }

  void addDwell(std::size_t index, std::size_t move) {
    const double duration_s = dwellAfter(script_.job_.toolpath, script_.paths_, index, move);
    if (duration_s == 0.0) return;
    statements_.emplace_back(NoteLine{std::string(kDwellNote)});
    statements_.emplace_back(ProgramWait{duration_s});
  }

  RobotStatement processSwitch(bool is_on) const {
    const ArcSettings& arc = script_.settings_.arc;
    if (arc.process == RobotProcess::Outputs) return OutputSwitch{script_.settings_.process_output, is_on};
    return ArcSwitch{is_on, is_on ? arc.start_schedule : arc.end_schedule, arc.weave_schedule};
  }

  void addStart() {
    statements_.push_back(processSwitch(true));
    if (script_.settings_.process_lead_s > 0.0)
      statements_.emplace_back(ProgramWait{script_.settings_.process_lead_s});
  }

  void addEnd() {
    statements_.push_back(processSwitch(false));
    for (const RobotLevel& level : script_.levels_)
      statements_.emplace_back(LevelChange{level.output, 0.0, false});
    if (script_.settings_.process_end_s > 0.0)
      statements_.emplace_back(ProgramWait{script_.settings_.process_end_s});
  }

  const RobotScript& script_;
  double rise_mm_;
  std::vector<double> stated_;  ///< of each level
  bool rests_ = true;           ///< the tip, since the last move
  std::vector<RobotStatement> statements_;
};

std::vector<RobotStatement> RobotScript::statements(const RobotStretch& stretch) const {
  const double rise_mm =
      (job_.bed_from_part.linear() * layerNormal(job_.toolpath)).dot(job_.bed_from_part.translation());
  Stretch writing(*this, rise_mm);
  for (std::size_t p = stretch.begin; p < stretch.end; ++p) writing.addPath(p);
  return writing.take();
}

}  // namespace lamina
