// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/reader/robot_run.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/robot/notes/path_notes.hpp"
#include "program/robot/notes/robot_notes.hpp"

namespace lamina {
namespace {

constexpr double kFarthestFrame = 1e6;  // mm
constexpr double kUnitTurn = 1e-6;      // by which a quaternion may be off its length
constexpr double kGreatestJoint = 1e5;  // deg
constexpr int kLastOutput = 99999;
constexpr double kHeaviestTool = 1e4;  // kg

double boundedNumber(NoteWords& words, double limit, const char* expected) {
  const auto value = words.number<double>(expected);
  if (!(std::abs(value) <= limit)) words.refuse(numberText(value), expected);
  return value;
}

Eigen::Quaterniond notedTurn(NoteWords& words) {
  std::array<double, 4> q{};
  for (double& each : q) each = boundedNumber(words, 2.0, "w x y z of an orientation");
  const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
  if (!(std::abs(turn.norm() - 1.0) <= kUnitTurn))
    words.refuse(numberText(turn.norm()), "an orientation of length 1");
  return turn.normalized();
}

Eigen::Isometry3d notedFrame(NoteWords& words) {
  Point3 at;
  for (int axis = 0; axis < 3; ++axis)
    at[axis] = boundedNumber(words, kFarthestFrame, "x y z of a frame in mm");
  Eigen::Isometry3d frame(notedTurn(words));
  frame.translation() = at;
  return frame;
}

ControllerMap notedMap(NoteWords& words) {
  ControllerMap map;
  for (double& sign : map.signs) {
    sign = boundedNumber(words, 1.0, "1 or -1 for each joint");
    if (std::abs(sign) != 1.0) words.refuse(std::to_string(sign), "1 or -1 for each joint");
  }
  for (double& zero : map.zeros_deg) zero = boundedNumber(words, 1e4, "the zero of each joint in deg");
  map.joint_3_from_2 = boundedNumber(words, 1.0, "the share of joint 2 in joint 3, -1 to 1");
  return map;
}

ExternalEntry notedExternal(NoteWords& words, std::size_t slot) {
  ExternalEntry entry;
  entry.joint = std::string(words.next());
  entry.slot = slot;
  entry.sign = boundedNumber(words, 1.0, "1 or -1 for an external axis");
  if (std::abs(entry.sign) != 1.0) words.refuse(numberText(entry.sign), "1 or -1 for an external axis");
  entry.zero = boundedNumber(words, 1e5, "the zero of an external axis in mm or deg");
  return entry;
}

ControllerJoints notedJoints(NoteWords& words) {
  ControllerJoints joints;
  for (double& each : joints.arm_deg)
    each = boundedNumber(words, kGreatestJoint, "the angle of each joint in deg");
  return joints;
}

int notedOutput(NoteWords& words) {
  const int output = words.number<int>("the number of an output");
  if (output < 0 || output > kLastOutput) words.refuse(std::to_string(output), "the number of an output");
  return output;
}

ToolLoad notedLoad(NoteWords& words) {
  ToolLoad load;
  load.mass_kg = boundedNumber(words, kHeaviestTool, "the mass of the tool in kg");
  for (int axis = 0; axis < 3; ++axis)
    load.centre_mm[axis] = boundedNumber(words, kFarthestFrame, "x y z of the tool's centre in mm");
  return load;
}

/// In words, as a property of the cell that is to be the same.
std::string loadText(const ToolLoad& load) {
  std::string text = "a tool of " + shortestText(load.mass_kg) + " kg with its centre at";
  for (const double each : load.centre_mm) text += " " + shortestText(each);
  return text + " mm";
}

RobotLevel notedLevel(NoteWords& words) {
  RobotLevel level;
  level.name = std::string(words.next());
  level.output = notedOutput(words);
  level.per = boundedNumber(words, 1e12, "what the output is set to for each unit");
  if (level.name.empty() || std::abs(level.per) < 1e-12)
    words.refuse(level.name, "a process value, its output, and how much that is for each unit");
  return level;
}

/// Runs one statement after the other.
class RobotRun {
 public:
  explicit RobotRun(const std::string& note_mark) : assembly_({note_mark, "the move", "the program"}) {}

  void run(const RobotScriptFile& file) {
    file_ = &file.name;
    running_.files.push_back(file.name);
    passage_ = Passage::None;
    is_tool_stated_ = false;
    for (const ReadStatement& statement : file.statements) {
      line_ = statement.line;
      is_dwelling_ &= std::holds_alternative<ProgramWait>(statement.what);
      std::visit([this](const auto& each) { add(each); }, statement.what);
    }
  }

  RobotRunning finish() {
    for (const PathNote& note : notes_.take())
      refuseAt(note.line, "a path has no moves; expected them behind its note");
    assembly_.end(line_);
    running_.program = assembly_.finish();
    running_.program.toolpath.part_from_layers = running_.head.bed_from_layers;
    return std::move(running_);
  }

 private:
  enum class Passage : std::uint8_t { None, Approach, Retract };

  [[noreturn]] void refuseAt(std::size_t line, const std::string& what) const {
    throw InvalidProgram("'" + *file_ + "' line " + std::to_string(line) + ": " + what);
  }

  void add(const NoteLine& note) {
    NoteWords words(note.text, line_, *file_);
    // Of whoever parsed the file.
    if (words.take("speeds") || words.take(kPulsesNote) || words.take(kExternalPulsesNote)) return;
    if (words.take(kArcOnNote) || words.take(kArcOffNote)) {
      has_arc_texts_ = true;
      running_.equipment.process.insert(note.text);
      return;
    }
    if (words.take(kJointsNote)) {
      joints_ = notedJoints(words);
      return words.expectEnd();
    }
    is_dwelling_ = words.take(kDwellNote);
    if (is_dwelling_) return words.expectEnd();
    if (words.take(kApproachNote)) {
      passage_ = Passage::Approach;
    } else if (words.take(kRetractNote)) {
      passage_ = Passage::Retract;
    } else if (!addToHead(words)) {
      notes_.read(words);
      return;
    }
    words.expectEnd();
  }

  /// The first file of a program states each of them, once.
  void addExternal(NoteWords& words) {
    std::vector<ExternalEntry>& external = running_.head.map.external;
    ExternalEntry entry = notedExternal(words, external.size());
    for (const ExternalEntry& each : external)
      if (each.joint == entry.joint) words.refuse(entry.joint, "a note of each external joint once");
    external.push_back(std::move(entry));
  }

  /// Whether it is a note on the whole program.
  bool addToHead(NoteWords& words) {
    RobotHeadNotes& head = running_.head;
    if (words.take("file")) return words.next(), true;
    if (words.take("tool")) return head.tool = notedFrame(words), true;
    if (words.take("bed")) return head.bed = notedFrame(words), true;
    if (words.take("process")) return head.process_output = notedOutput(words), true;
    if (words.take(kLoadNote)) {
      head.load = notedLoad(words);
      running_.equipment.process.insert(loadText(*head.load));
      return true;
    }
    if (words.take(kDryFlagNote)) {
      running_.equipment.process.insert("dry run by variable " + std::to_string(notedOutput(words)));
      return true;
    }
    if (words.take(kDrySpeedNote)) {
      const double percent = boundedNumber(words, 100.0, "the speed of a dry run in percent");
      running_.equipment.process.insert("dry run at " + shortestText(percent) + " % of the speed");
      return true;
    }
    if (words.take("joints")) {
      std::vector<ExternalEntry> external = std::move(head.map.external);
      head.map = notedMap(words);
      head.map.external = std::move(external);
      return true;
    }
    if (words.take(kExternalNote)) return addExternal(words), true;
    if (words.take("layers")) return head.bed_from_layers = notedTurn(words), true;
    if (words.take("level")) {
      const RobotLevel level = notedLevel(words);
      running_.equipment.process.insert("analogue output " + std::to_string(level.output) + " of " +
                                        level.name + " by " + shortestText(level.per));
      return head.levels.push_back(level), true;
    }
    if (!words.take("carried_bed")) return false;
    head.bed = notedFrame(words);
    running_.equipment.bed_carrier = "an external axis";
    return head.is_bed_carried = true;
  }

  void add(const JointMove& move) {
    if (passage_ != Passage::Approach)
      refuseAt(line_, "found a move of the joints amid the part; expected a note of an approach before it");
    requireOff("an approach");
    passage_ = Passage::None;
    const std::optional<ControllerJoints> noted = std::exchange(joints_, std::nullopt);
    if (move.pose && !noted)
      refuseAt(line_, "found a move of the joints to a pose; expected a note of these joints before it");
    RunWay way;
    way.before = running_.moves.size();
    way.joints = move.pose ? *noted : move.joints;
    way.joints->external = move.joints.external;
    way.line = line_;
    running_.ways.push_back(std::move(way));
  }

  void add(const TipMove& move) {
    // Poses over the base are those of the language that has no tools by number.
    if (move.is_over_base && !is_tool_stated_ && running_.head.untold_tool.empty())
      running_.head.untold_tool = place();
    const bool is_way_back = passage_ == Passage::Approach && !running_.ways.empty();
    if (passage_ == Passage::Retract || is_way_back) {
      requireOff(passage_ == Passage::Retract ? "a retract" : "an approach");
      passage_ = Passage::None;
      return addWay(move);
    }
    for (const PathNote& note : notes_.take()) assembly_.addNote(note, *file_);
    const Eigen::Isometry3d pose = overBed(move);
    AssembledMove assembled;
    assembled.point = pose.translation();
    assembled.orientation =
        move.is_over_base ? Eigen::Quaterniond(pose.linear()).normalized() : move.orientation;
    assembled.feed_mm_s = move.feed_mm_s;
    for (const RobotLevel& level : running_.head.levels)
      if (const auto found = levels_.find(level.output); found != levels_.end())
        assembled.values[level.name] = found->second / level.per;
    assembled.index = running_.moves.size();
    assembly_.add(assembled, process_, line_);
    StatedEquipment& equipment = running_.equipment;
    if (running_.moves.empty()) equipment.external = move.external;
    equipment.moves_external |= equipment.external != move.external;
    running_.moves.push_back({move.external, line_, running_.files.size() - 1, move.feed_mm_s});
  }

  Eigen::Isometry3d overBed(const TipMove& move) const {
    Eigen::Isometry3d pose(move.orientation);
    pose.translation() = move.point;
    if (!move.is_over_base) return pose;
    return running_.head.bed.value_or(Eigen::Isometry3d::Identity()).inverse() * pose;
  }

  void addWay(const TipMove& move) {
    RunWay way;
    way.before = running_.moves.size();
    way.pose = overBed(move);
    way.external = move.external;
    way.feed_mm_s = move.feed_mm_s;
    way.line = line_;
    running_.ways.push_back(std::move(way));
  }

  void requireOff(const char* where) const {
    if (process_ == ProcessState::On)
      refuseAt(line_, std::string("the process is on in ") + where + "; expected it off");
  }

  void add(const OutputSwitch& output) {
    if (output.output != running_.head.process_output)
      refuseAt(line_, "found output " + std::to_string(output.output) + "; expected " +
                          std::to_string(running_.head.process_output) + ", that of the process");
    process_ = output.is_on ? ProcessState::On : ProcessState::Off;
    running_.equipment.process.insert("output " + std::to_string(output.output));
  }

  void add(const LevelChange& change) {
    for (const RobotLevel& level : running_.head.levels)
      if (level.output == change.output) {
        levels_[change.output] = change.value;
        return;
      }
    refuseAt(line_, "found analogue output " + std::to_string(change.output) +
                        "; expected one that a note of a level names");
  }

  void add(const ArcSwitch& arc) {
    process_ = arc.is_on ? ProcessState::On : ProcessState::Off;
    // Templates have their numbers in their notes.
    if (has_arc_texts_) return;
    std::set<std::string>& process = running_.equipment.process;
    process.insert(std::string("arc ") + (arc.is_on ? "start" : "end") + " by schedule " +
                   std::to_string(arc.schedule));
    if (arc.weave > 0) process.insert("weave by schedule " + std::to_string(arc.weave));
  }

  /// Others are the process's own.
  void add(const ProgramWait& wait) {
    if (is_dwelling_)
      assembly_.addDwell(wait.duration_s, line_);
    else
      running_.equipment.process.insert("wait of " + shortestText(wait.duration_s) + " s");
  }
  void add(const FileCall&) {}
  void add(const ToolStatement& tool) {
    is_tool_stated_ |= tool.flange_from_tip.has_value();
    running_.head.stated_tools.push_back({tool, place()});
  }

  std::string place() const { return "'" + *file_ + "' line " + std::to_string(line_); }

  PathAssembly assembly_;
  PathNotes notes_;
  RobotRunning running_;
  const std::string* file_ = nullptr;
  std::size_t line_ = 0;
  Passage passage_ = Passage::None;
  ProcessState process_ = ProcessState::Off;
  bool is_tool_stated_ = false;             ///< by a statement of this file
  bool is_dwelling_ = false;                ///< a note of a dwell comes right before
  bool has_arc_texts_ = false;              ///< notes hold the statements of the arc package
  std::map<int, double> levels_;            ///< as they stand
  std::optional<ControllerJoints> joints_;  ///< of a note
};

}  // namespace

RobotRunning runRobot(const std::vector<RobotScriptFile>& files, const std::string& note_mark) {
  RobotRun run(note_mark);
  for (const RobotScriptFile& file : files) run.run(file);
  return run.finish();
}

}  // namespace lamina
