// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/joint_program.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "job/arm/clear_branches.hpp"
#include "job/raised_axes.hpp"
#include "joint_program.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "lamina/program/rapid/rapid_texts.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace lamina {
namespace {

/// A toolpath and joints whose nozzle is turned about the tool axis as they turn it.
struct ToolpathAsRun {
  Toolpath toolpath;
  JointPath joints;
};

constexpr double kSameTurn = 1e-6;    // rad: under what targets resolve
constexpr double kSameJoints = 1e-3;  // rad, mm: above what the digits of targets leave open

/// What a closed path has at its first waypoint is that of its return.
template <typename Value>
AlongPath<Value> withReturn(const AlongPath<Value>& along) {
  if (along.isCommon()) return along;
  std::vector<Value> each = along.values();
  each.push_back(each.front());
  return AlongPath<Value>(std::move(each));
}

void open(Path& path) {
  path.is_closed = false;
  path.points.push_back(path.points.front());
  path.bead = withReturn(path.bead);
  path.feed_mm_s = withReturn(path.feed_mm_s);
  for (ProcessValue& each : path.values) each.value = withReturn(each.value);
}

/// Takes the joints of one path after the other.
class Turner {
 public:
  Turner(const KinematicModelRun& run, const KinematicModel& model)
      : part_from_bed_(Eigen::Quaterniond(run.bed_from_part.linear()).conjugate()), model_(model) {}

  void turn(Path& path, JointPath& joints) {
    if (next_ == 0) last_ = path.orientation.at(0);
    std::vector<Eigen::Quaterniond> each;
    for (std::size_t station = 0; station <= path.motionCount(); ++station) each.push_back(nextTurn(joints));
    if (path.is_closed && each.front().angularDistance(each.back()) > kSameTurn) {
      open(path);
      joints.at[next_ - 1].waypoint = path.points.size() - 1;
    }
    if (path.is_closed) each.pop_back();
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  }

 private:
  Eigen::Quaterniond nextTurn(const JointPath& joints) {
    const Eigen::Isometry3d nozzle = model_.bedFromNozzle(joints.values[next_++]);
    Eigen::Quaterniond turn = part_from_bed_ * Eigen::Quaterniond(nozzle.linear());
    if (turn.dot(last_) < 0.0) turn.coeffs() *= -1.0;
    return last_ = turn.normalized();
  }

  Eigen::Quaterniond part_from_bed_;
  const KinematicModel& model_;
  std::size_t next_ = 0;
  Eigen::Quaterniond last_ = Eigen::Quaterniond::Identity();
};

/// The divided toolpath of a run that has no faults, with the orientations that the joints bring about, their
/// signs such that they keep from waypoint to waypoint. A closed path at whose end the nozzle is turned
/// another way than at its beginning becomes an open one that ends where it began.
ToolpathAsRun toolpathAsRun(KinematicModelRun run, const KinematicModel& model) {
  Turner turner(run, model);
  ToolpathAsRun result{std::move(run.divided.toolpath), std::move(run.path)};
  for (ToolpathLayer& layer : result.toolpath.layers)
    for (Path& path : layer.paths) turner.turn(path, result.joints);
  return result;
}

constexpr double kHeldToolAxis = toRadians(0.01);  // rad: as a program of linear axes holds it

bool hasExternalAxis(const KinematicModel& arm) { return arm.joints().size() > 6; }

/// Other languages than RAPID always state them.
bool statesJoints(const SliceJob& job, const KinematicModel& arm) {
  const RapidSettings& settings = job.settings.program.rapid;
  if (programRunner(job.output) == ProgramRunner::OtherRobot) return true;
  return settings.variant == RapidVariant::Powder5Axes &&
         (settings.configuration == RapidConfiguration::Joints || hasExternalAxis(arm));
}

/// Offsets from one point state neither how the tool is turned nor where external axes stand.
void requireStated(const JointPathSettings& joints, const SliceJob& job, const KinematicModel& arm) {
  const RapidSettings& settings = job.settings.program.rapid;
  if (programRunner(job.output) == ProgramRunner::OtherRobot) return;
  if (settings.variant == RapidVariant::Powder5Axes || !hasExternalAxis(arm)) return;
  const bool is_rail_moved = joints.rail != RailChoice::Held;
  if (is_rail_moved || joints.external != ExternalChoice::Held)
    throw InvalidConfig(std::string(is_rail_moved ? "joints.rail" : "joints.external") +
                        " is not held with rapid.variant " + toString(settings.variant) +
                        ", which reports external axes at one point only; expected held, or powder_5_axes");
}

/// Whether the output is what a machine that turns the tool axis is driven by, without a program of its own.
bool statesPoses(const SliceJob& job) {
  return isToolpathFile(job.output) && canTurnToolAxis(buildSpaceOf(job.settings.machine));
}

bool isProgram(const SliceJob& job) { return isGcodeFile(job.output) || isRobotFile(job.output); }

/// Of what no joints are led for.
bool needsClearance(const SliceJob& job, const SlicedPart& sliced) {
  if (job.settings.clearance.need == ClearanceNeed::Turning && hasPlaneLayers(sliced.summary.mode))
    return false;
  return isRefusedUnlessClear(job);
}

/// Whether a tool axis leans that may lean less.
bool mayRaise(const JobSettings& settings, const SlicedPart& sliced) {
  const BuildSpace space = buildSpaceOf(settings.machine);
  return settings.clearance.raises_tool_axis && canTurnToolAxis(space) &&
         greatestToolAxisTurn(sliced.toolpath, sliced.bed_from_part, space) > kHeldToolAxis;
}

CheckedRun plainRun(const CheckedMachine& machine, const SliceJob& job, const SlicedPart& sliced,
                    const JointPathSettings& joints, Progress& progress) {
  const RunPlanner plan = [&](const JointGuard& guard) {
    return runOn(GuardedModel{machine.model(), guard}, sliced.toolpath, sliced.bed_from_part, joints,
                 progress);
  };
  return checkedRun(machine, plan, job.settings.clearance, progress);
}

/// A part whose tool axis leans, raised where the machine would run into something, or cannot get there, as
/// long as that leaves less of it.
CheckedRun raisedRun(const CheckedMachine& machine, const SliceJob& job, SlicedPart& sliced,
                     const JointPathSettings& joints, Progress& progress) {
  std::optional<KinematicModelRun> last;
  const Toolpath wanted = std::move(sliced.toolpath);
  RaisedToolpath raised = raiseToolAxes(
      wanted, {machine.model(), sliced.bed_from_part, job.settings}, [&](const Toolpath& toolpath) {
        const RunPlanner plan = [&](const JointGuard& guard) {
          return runOn(GuardedModel{machine.model(), guard}, toolpath, sliced.bed_from_part, joints,
                       progress);
        };
        CheckedRun checked = checkedRun(machine, plan, job.settings.clearance, progress);
        last = std::move(checked.run);
        return std::move(checked.check);
      });
  sliced.toolpath = std::move(raised.toolpath);
  if (raised.waypoints > 0) sliced.summary.notes.push_back(noteOnRaised(raised));
  return {*std::move(last), std::move(raised.check)};
}

/// @throws Unreachable as `requireRunnable` and `requireClear`, with what to try
void requireClearFor(const SliceJob& job, const std::string& mode, const CheckedRun& checked,
                     const KinematicModel& model) {
  if (hasPlaneLayers(mode)) requireRunnable(checked.run, model);
  try {
    requireRunnable(checked.run, model);
    requireClear(checked.check, model);
  } catch (const Unreachable& refusal) {
    const auto areOfMachine = [](const Finding& finding) {
      return finding.meeting.find(" in link '") != std::string::npos;
    };
    const bool is_built_in =
        !checked.check.collisions.empty() &&
        std::all_of(checked.check.collisions.begin(), checked.check.collisions.end(), areOfMachine);
    throw Unreachable(
        refusal.what() + remediesFor(job, mode) +
        (is_built_in
             ? "; links that are built into each other are exempted by the description (lamina_ignore, "
               "or ignore of a cell)"
             : ""));
  }
}

/// @throws Unreachable if the machine cannot run the part, or would run into something
KinematicModelRun runnable(const KinematicModel& model, const SliceJob& job, SlicedPart& sliced,
                           const JointPathSettings& joints, Progress& progress) {
  if (job.settings.clearance.need == ClearanceNeed::Never) {
    KinematicModelRun run = runOn(model, sliced.toolpath, sliced.bed_from_part, joints, progress);
    requireRunnable(run, model);
    return run;
  }
  const CheckedMachine machine(model);
  CheckedRun checked = mayRaise(job.settings, sliced) ? raisedRun(machine, job, sliced, joints, progress)
                                                      : plainRun(machine, job, sliced, joints, progress);
  requireClearFor(job, sliced.summary.mode, checked, model);
  return std::move(checked.run);
}

/// A bead that joints cannot follow in time is what `lamina check` refuses; the program is the same.
std::optional<RunTime> timeOf(const KinematicModelRun& run, const KinematicModel& model,
                              const JobSettings& settings) {
  try {
    return inTime(run, model, runSettings(settings).timing).figures;
  } catch (const Unreachable&) {
    return std::nullopt;
  }
}

/// The joints at the waypoints of the toolpath before it was divided.
JointPath atWaypointsAskedFor(const KinematicModelRun& run) {
  JointPath kept;
  kept.tool_axis_tolerance = run.path.tool_axis_tolerance;
  kept.rewinds = run.path.rewinds;
  const auto isSamePath = [](const WaypointIndex& a, const WaypointIndex& b) {
    return a.layer == b.layer && a.path == b.path;
  };
  const auto& at = run.path.at;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const bool is_first = i == 0 || !isSamePath(at[i - 1], at[i]);
    const bool is_last = i + 1 == at.size() || !isSamePath(at[i], at[i + 1]);
    const WaypointIndex original = run.divided.originalOf(at[i]);
    if (!is_first && !is_last && run.divided.originalOf(at[i + 1]) == original) continue;
    kept.at.push_back(original);
    kept.values.push_back(run.path.values[i]);
  }
  return kept;
}

JointProgram planMachine(std::unique_ptr<KinematicModel> machine, const SliceJob& job, SlicedPart& sliced,
                         Progress& progress) {
  KinematicModelRun run = runnable(*machine, job, sliced, job.settings.joints, progress);
  const auto time = timeOf(run, *machine, job.settings);
  return {std::move(machine), std::move(run.divided.toolpath), std::move(run.path), time};
}

/// The motion of an arm by poses alone, as its controller reads them from the module that would be written;
/// nothing if the module is not read back, as with a tool other than that of the arm's description.
std::optional<StatedMotion> motionByPoses(const JointProgram& planned, const RapidSettings& settings,
                                          const Eigen::Isometry3d& bed_from_part) {
  const RobotMotion motion{*planned.model, planned.joints};
  const RapidProgram program(planned.toolpath, bed_from_part, settings, &motion);
  try {
    return readRapidMotion(RapidTexts(program).modules(), planned.toolpath.part_name, *planned.model);
  } catch (const InvalidProgram&) {
    return std::nullopt;
  }
}

/// Whether an arm goes by poses alone as it was planned to.
bool isAsPlanned(const StatedMotion& motion, const JointPath& planned) {
  const auto isAlike = [](const JointValues& one, const JointValues& other) {
    return one.size() == other.size() && (one - other).cwiseAbs().maxCoeff() <= kSameJoints;
  };
  return std::equal(motion.joints.values.begin(), motion.joints.values.end(), planned.values.begin(),
                    planned.values.end(), isAlike);
}

/// What stands in the way of an arm that goes by poses alone.
MachineCheck checkByPoses(const JointProgram& planned, const SliceJob& job, const SlicedPart& sliced,
                          const JointPathSettings& settings, Progress& progress) {
  std::optional<StatedMotion> motion =
      motionByPoses(planned, job.settings.program.rapid, sliced.bed_from_part);
  if (!motion || isAsPlanned(*motion, planned.joints)) return {};
  const CheckedMachine machine(*planned.model);
  return checkRun(runAsStated(*planned.model, *std::move(motion), settings), machine, job.settings.clearance,
                  progress);
}

std::optional<JointProgram> planArm(std::unique_ptr<KinematicModel> arm, const SliceJob& job,
                                    SlicedPart& sliced, Progress& progress);

/// A program that states configurations, for an arm that would not get through by poses alone.
std::optional<JointProgram> planConfigured(std::unique_ptr<KinematicModel> arm, const MachineCheck& by_poses,
                                           const SliceJob& job, SlicedPart& sliced, Progress& progress) {
  SliceJob configured = job;
  configured.settings.program.rapid.configuration = RapidConfiguration::Joints;
  configured.settings.joints.yaw = YawChoice::Held;  // the targets are those that were asked for
  std::optional<JointProgram> program = planArm(std::move(arm), configured, sliced, progress);
  program->needs_configurations = true;
  sliced.summary.notes.push_back(
      "the program states the arm's configurations, as with rapid.configuration joints: by poses alone the "
      "arm, which takes the joints nearest to those before, could not run it at " +
      std::to_string(by_poses.faults.size() + by_poses.collisions.size()) + " waypoints");
  return program;
}

std::optional<JointProgram> planArm(std::unique_ptr<KinematicModel> arm, const SliceJob& job,
                                    SlicedPart& sliced, Progress& progress) {
  const JointPathSettings settings = jointsOf(job, *arm);
  requireStated(settings, job, *arm);
  const bool is_stated = statesJoints(job, *arm);
  KinematicModelRun run = runnable(*arm, job, sliced, settings, progress);
  const auto time = timeOf(run, *arm, job.settings);
  if (!is_stated) {
    JointProgram planned{std::move(arm), sliced.toolpath, atWaypointsAskedFor(run), time};
    if (job.settings.clearance.need == ClearanceNeed::Never ||
        job.settings.program.rapid.variant != RapidVariant::Powder5Axes)
      return planned;
    const MachineCheck check = checkByPoses(planned, job, sliced, settings, progress);
    if (check.isClear()) return planned;
    return planConfigured(std::move(planned.model), check, job, sliced, progress);
  }
  ToolpathAsRun as_run = toolpathAsRun(std::move(run), *arm);
  return JointProgram{std::move(arm), std::move(as_run.toolpath), std::move(as_run.joints), time};
}

/// Programs state six joints, and neither the arm angle of seven axes nor what five cannot reach.
void refuseOtherArms(const SliceJob& job, const BuildSpace& space) {
  if (!isProgram(job) || !canTurnToolAxis(space)) return;
  const auto model = kinematicModelOf(job.settings.machine);
  if (!isArm(*model) || isSixAxisArm(*model)) return;
  const std::string axes = model->redundancy() == nullptr ? "five" : "seven";
  throw InvalidInput("output '" + job.output + "' is a program, but the machine '" + space.name +
                     "' is an arm of " + axes +
                     " axes, and programs are written for arms of six; expected .csv, which is driven by "
                     "joints (trajectory_driver)");
}

std::string checkCommand(const std::string& input, const MachineSettings& machine) {
  return "lamina check " + input + " --machine " + (machine.urdf.empty() ? machine.name : machine.urdf);
}

/// A program that begins with a move of joints.
void requireSixJoints(const SliceJob& job, const BuildSpace& space) {
  if (canTurnToolAxis(space) && isSixAxisArm(*kinematicModelOf(job.settings.machine))) return;
  throw InvalidInput("output '" + job.output + "' is a program in " + robotLanguageName(job.output) +
                     ", but the machine '" + space.name +
                     "' is no arm with six joints; expected one (machine.name, machine.urdf)");
}

}  // namespace

JointPathSettings jointsOf(const SliceJob& job, const KinematicModel& model) {
  JointPathSettings settings = job.settings.joints;
  if (isRobotFile(job.output) && isSixAxisArm(model) && !statesJoints(job, model))
    settings.yaw = YawChoice::Held;
  return settings;
}

bool isRefusedUnlessClear(const SliceJob& job) {
  switch (job.settings.clearance.need) {
    case ClearanceNeed::Never:
      return false;
    case ClearanceNeed::Always:
      return !job.output.empty();
    case ClearanceNeed::Turning:
      return isProgram(job) || statesPoses(job);
  }
  return false;
}

std::string remediesFor(const SliceJob& job, const std::string& mode) {
  std::vector<std::string> remedies = {"another machine (machine.name)"};
  if (mode == "volumetric") {
    remedies.emplace_back("a part that is cut off higher (volumetric.sink_mm)");
    remedies.emplace_back("layers that tilt less (volumetric.max_tilt_deg)");
  }
  if (mode == "heightfield") remedies.emplace_back("layers that slope less (heightfield.max_slope_deg)");
  if (hasPlaneLayers(mode)) {
    remedies.emplace_back("a tool axis that leans less (orientation.*)");
    if (!job.settings.clearance.raises_tool_axis)
      remedies.emplace_back("or only where there is room (clearance.raise_tool_axis)");
  } else {
    if (canTurnToolAxis(buildSpaceOf(job.settings.machine)))
      remedies.emplace_back(
          "leaving out more of the beads that the head has no room for "
          "(volumetric.largest_left_out_percent)");
    remedies.emplace_back("another mode (slicing.mode auto or planar)");
  }
  return "; try " + listed(remedies);
}

std::string noteOnUnchecked(const SliceJob& job, const std::string& mode) {
  const JobSettings& settings = job.settings;
  const bool are_plane_poses =
      settings.clearance.need == ClearanceNeed::Turning && !isProgram(job) && hasPlaneLayers(mode);
  if (job.output.empty() || settings.clearance.need == ClearanceNeed::Never ||
      (isRefusedUnlessClear(job) && !are_plane_poses))
    return "";
  return "it was not checked whether the machine runs into bed, part or itself: '" + job.output +
         "' is no program of it (clearance.need turning); '" + checkCommand(job.output, settings.machine) +
         "' tells, and with clearance.need always only what is clear is written";
}

void addNoteOnTipTime(SlicedPart& sliced, const SliceJob& job, const BuildSpace& space) {
  if (!canTurnToolAxis(space)) return;
  const MachineSettings& machine = job.settings.machine;
  const bool is_robot = kinematicModelOf(machine)->toolAxisSpin() == ToolAxisSpin::Given;
  if (!is_robot && greatestToolAxisTurn(sliced.toolpath, sliced.bed_from_part, space) <= kHeldToolAxis)
    return;
  sliced.summary.notes.push_back(
      "the print time is that of the nozzle's tip alone; the joints may need longer: '" +
      checkCommand(job.output.empty() ? job.part : job.output, machine) +
      "' tells the time within their limits");
}

void requireProgramFor(const SliceJob& job, const BuildSpace& space) {
  refuseOtherArms(job, space);
  if (programRunner(job.output) == ProgramRunner::OtherRobot) {
    requireSixJoints(job, space);
    const std::string name = std::filesystem::path(job.output).stem().string();
    return requireWritable({*robotLanguageOf(job.output), name, job.settings.program.robot},
                           *kinematicModelOf(job.settings.machine));
  }
  if (programRunner(job.output) == ProgramRunner::RapidRobot)
    requireControllerKind(kinematicModelOf(job.settings.machine)->urdf(), "abb", "RAPID");
  if (!isGcodeFile(job.output) || !canTurnToolAxis(space)) return;
  if (kinematicModelOf(job.settings.machine)->toolAxisSpin() == ToolAxisSpin::Given)
    throw InvalidInput("output '" + job.output + "' is G-code, but the machine '" + space.name +
                       "' is a robot without axes x, y and z; expected a robot's program (.mod, .src, "
                       ".script, .ls, .jbi) or .csv");
}

bool writesFiveAxis(const SliceJob& job, const BuildSpace& space, const SlicedPart& sliced) {
  if (!isGcodeFile(job.output) || !canTurnToolAxis(space)) return false;
  return job.settings.program.five_axis.use == FiveAxisUse::Always ||
         greatestToolAxisTurn(sliced.toolpath, sliced.bed_from_part, space) > kHeldToolAxis;
}

std::optional<JointProgram> planJointProgram(const SliceJob& job, const BuildSpace& space, SlicedPart& sliced,
                                             Progress& progress) {
  if (writesFiveAxis(job, space, sliced))
    return planMachine(kinematicModelOf(job.settings.machine), job, sliced, progress);
  if (isRobotFile(job.output) && canTurnToolAxis(space)) {
    std::unique_ptr<KinematicModel> arm = kinematicModelOf(job.settings.machine);
    if (isSixAxisArm(*arm)) return planArm(std::move(arm), job, sliced, progress);
  }
  if (needsClearance(job, sliced))
    runnable(*kinematicModelOf(job.settings.machine), job, sliced, job.settings.joints, progress);
  return std::nullopt;
}

}  // namespace lamina
