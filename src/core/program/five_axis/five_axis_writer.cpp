// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/five_axis/five_axis_writer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/one_line.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/five_axis/five_axis_settings.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/process_support.hpp"
#include "program/arc_refusal.hpp"
#include "program/five_axis/fanuc_text.hpp"
#include "program/five_axis/five_axis_chords.hpp"
#include "program/five_axis/five_axis_events.hpp"
#include "program/five_axis/five_axis_letters.hpp"
#include "program/gcode/extrusion.hpp"
#include "program/gcode/fixed_point.hpp"
#include "program/gcode/start_code.hpp"
#include "program/listed_paths.hpp"
#include "program/program_stations.hpp"
#include "program/text_piece.hpp"

namespace lamina {
namespace {

/// One line's target and how it is reached.
struct FiveAxisTarget {
  JointValues joints;
  Point3 tip = Point3::Zero();  ///< [mm, bed]
  double filament_mm = 0.0;     ///< deposited on the way
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
  /// Lifts the tip along the tool axis, as far as the linear joints let it.
  void leave(double lift_mm, std::string& text);
  /// Filament alone.
  void retract(double length_mm, std::string& text);
  void comment(const char* key, double value, std::string& text);

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  std::int64_t unitsOf(std::size_t axis, const JointValues& joints, const Point3& tip) const;
  std::string word(std::size_t axis, std::int64_t units) const;
  std::string moduloWord(char letter, std::int64_t units) const;
  /// Words of the axes from `begin` to `end` that change.
  std::string changes(std::size_t begin, std::size_t end, const JointValues& joints, const Point3& tip);
  std::string feedWord(double per_minute);
  std::string feederWords(std::int64_t units);

  const KinematicModel& machine_;
  std::vector<AxisLetter> letters_;
  bool has_joints_;  ///< and inverse-time feed
  bool has_fanuc_feeds_;
  std::string modulo_;  ///< letters of axes whose words stand within one turn
  FeederWord feeder_;
  std::int64_t fed_ = 0;  ///< material since the start of the part, what is pulled back taken off
  double retraction_feed_mm_s_;
  std::vector<std::int64_t> axes_;  ///< as written last
  std::int64_t feed_ = kUnknown;
  JointValues joints_;  ///< as of the line before
  Point3 tip_ = Point3::Zero();
  double filament_mm_ = 0.0;
  std::int64_t filament_ = 0;
  double waiting_s_ = 0.0;  ///< of motions too short to be written
};

constexpr double kLinearScale = 1e4;              // 4 decimals
constexpr double kRotaryScale = toDegrees(1e5);   // 5 decimals of a degree
constexpr std::int64_t kUnitsOfTurn = 36000000;   // hundred-thousandths of a degree
constexpr double kFarthestFanucAxis = 99999.999;  // deg or mm: what a control with increments of 0.001 takes
constexpr double kFilamentScale = 1e5;
constexpr std::size_t kLinear = 3;
constexpr std::int64_t kMostInverseTime =
    9999999;  // thousandths of 1/min: the most that a Fanuc control takes

template <int decimals>
std::string fixed(char letter, std::int64_t units) {
  char digits[32];
  return std::string(" ") + letter + std::string(digits, writeFixed<decimals>(digits, units));
}

FiveAxisLines::FiveAxisLines(const KinematicModel& machine, const FiveAxisSettings& settings,
                             const ProgramSettings& program)
    : machine_(machine),
      letters_(axisLetters(machine, settings.letters)),
      has_joints_(settings.coordinates == FiveAxisCoordinates::Joints),
      has_fanuc_feeds_(settings.dialect == FiveAxisDialect::Fanuc),
      modulo_(toText(moduloLetters(machine, settings))),
      feeder_(feederWord(settings)),
      retraction_feed_mm_s_(program.retraction_feed_mm_s),
      axes_(letters_.size(), kUnknown) {}

std::int64_t FiveAxisLines::unitsOf(std::size_t axis, const JointValues& joints, const Point3& tip) const {
  if (axis >= kLinear) return toUnits(joints[letters_[axis].joint], kRotaryScale);
  const double value = has_joints_ ? joints[letters_[axis].joint] : tip[static_cast<Eigen::Index>(axis)];
  return toUnits(value, kLinearScale);
}

std::string FiveAxisLines::word(std::size_t axis, std::int64_t units) const {
  const char letter = letters_[axis].letter;
  if (modulo_.find(letter) != std::string::npos) return moduloWord(letter, units);
  return axis < kLinear ? fixed<4>(letter, units) : fixed<5>(letter, units);
}

/// Axes of Fanuc with rollover take the shorter way by themselves, those of Siemens by DC.
std::string FiveAxisLines::moduloWord(char letter, std::int64_t units) const {
  const std::int64_t within = (units % kUnitsOfTurn + kUnitsOfTurn) % kUnitsOfTurn;
  if (has_fanuc_feeds_) return fixed<5>(letter, within);
  char digits[32];
  return std::string(" ") + letter + "=DC(" + std::string(digits, writeFixed<5>(digits, within)) + ")";
}

std::string FiveAxisLines::changes(std::size_t begin, std::size_t end, const JointValues& joints,
                                   const Point3& tip) {
  std::string words;
  for (std::size_t axis = begin; axis < end; ++axis) {
    const std::int64_t units = unitsOf(axis, joints, tip);
    if (units == axes_[axis]) continue;
    axes_[axis] = units;
    words += word(axis, units);
  }
  return words;
}

std::string FiveAxisLines::feedWord(double per_minute) {
  if (has_joints_ && has_fanuc_feeds_)
    return fixed<3>('F', std::clamp<std::int64_t>(toUnits(per_minute, 1e3), 1, kMostInverseTime));
  if (has_joints_) return fixed<5>('F', std::max<std::int64_t>(1, toUnits(per_minute, 1e5)));
  const std::int64_t units = std::max<std::int64_t>(1, toUnits(per_minute, 1e3));
  if (units == feed_) return "";
  feed_ = units;
  return fixed<3>('F', units);
}

std::string FiveAxisLines::feederWords(std::int64_t units) {
  fed_ += units;
  const double fed_mm = static_cast<double>(fed_) / kFilamentScale;
  if (has_fanuc_feeds_ && feeder_.is_absolute && std::abs(fed_mm) > kFarthestFanucAxis)
    throw InvalidInput(
        std::string("axis ") + feeder_.letter + " has fed " + numberText(fed_mm) +
        " mm of material; a Fanuc control takes 99 999.999 mm at most: expected a part of less "
        "material, or thicker filament (program.filament_diameter_mm)");
  return fixed<5>(feeder_.letter, feeder_.is_absolute ? fed_ : units);
}

void FiveAxisLines::approach(const JointValues& joints, const Point3& tip, const std::string& tip_control,
                             std::string& text) {
  if (letters_.size() > kLinear) text += "G0" + changes(kLinear, letters_.size(), joints, tip) + "\n";
  if (!tip_control.empty()) text += tip_control + "\n";
  text += "G0" + changes(0, 2, joints, tip) + "\n";
  text += "G0" + changes(2, kLinear, joints, tip) + "\n";
  joints_ = joints;
  tip_ = tip;
}

void FiveAxisLines::move(const FiveAxisTarget& target, std::string& text) {
  filament_mm_ += target.filament_mm;
  waiting_s_ += target.time_s;
  const std::int64_t filament = toUnits(filament_mm_, kFilamentScale);
  // Too little to be written: without E it would read as a travel. The next motion takes it along.
  if (target.filament_mm > 0.0 && filament == filament_) return;
  std::string words = changes(0, letters_.size(), target.joints, target.tip);
  if (words.empty()) return;
  if (filament != filament_) words += feederWords(filament - filament_);
  filament_ = filament;
  words += feedWord(has_joints_ ? 60.0 / waiting_s_ : 60.0 * target.feed);
  text.append("G1").append(words).append(target.remark).append("\n");
  waiting_s_ = 0.0;
  joints_ = target.joints;
  tip_ = target.tip;
}

void FiveAxisLines::turn(const JointValues& joints, std::string& text) {
  double time_s = 0.0;
  double square_deg = 0.0;
  bool has_changed = false;
  for (std::size_t axis = 0; axis < letters_.size(); ++axis) {
    const AxisLetter& letter = letters_[axis];
    const double way = std::abs(joints[letter.joint] - joints_[letter.joint]);
    const double speed = machine_.joints()[static_cast<std::size_t>(letter.joint)].max_speed;
    time_s = std::max(time_s, way / speed);
    if (axis >= kLinear) square_deg += way * way * kDegreesPerRadian * kDegreesPerRadian;
    // The same tip comes of other linear joints where rotary ones turn.
    has_changed |= axis >= kLinear && unitsOf(axis, joints, tip_) != axes_[axis];
  }
  if (!has_changed || !(time_s > 0.0)) return;
  FiveAxisTarget target;
  target.joints = joints;
  target.tip = tip_;
  target.remark = " ;turn";
  target.time_s = time_s;
  target.feed = std::sqrt(square_deg) / time_s;
  move(target, text);
}

void FiveAxisLines::leave(double lift_mm, std::string& text) {
  const Jacobian rates = machine_.jacobian(joints_);
  Eigen::Matrix3d directions;
  for (std::size_t i = 0; i < kLinear; ++i)
    directions.col(static_cast<Eigen::Index>(i)) = rates.col(letters_[i].joint).head<3>();
  const Eigen::Vector3d up = -machine_.bedFromNozzle(joints_).linear().col(2);
  const Eigen::Vector3d way_mm = lift_mm * (directions.inverse() * up);
  double share = 1.0;
  for (std::size_t i = 0; i < kLinear; ++i) {
    const DrivenJoint& joint = machine_.joints()[static_cast<std::size_t>(letters_[i].joint)];
    const double way = way_mm[static_cast<Eigen::Index>(i)];
    const double room = (way > 0.0 ? joint.high : joint.low) - joints_[letters_[i].joint];
    if (way != 0.0) share = std::clamp(room / way, 0.0, share);
  }
  for (std::size_t i = 0; i < kLinear; ++i)
    joints_[letters_[i].joint] += share * way_mm[static_cast<Eigen::Index>(i)];
  tip_ += share * lift_mm * up;
  const std::string words = changes(0, kLinear, joints_, tip_);
  if (!words.empty()) text += "G0" + words + " ;retract\n";
}

void FiveAxisLines::retract(double length_mm, std::string& text) {
  const std::int64_t units = toUnits(length_mm, kFilamentScale);
  if (units == 0) return;
  const double feed = retraction_feed_mm_s_;
  text += "G1" + feederWords(units) +
          feedWord(has_joints_ ? 60.0 * feed / std::abs(length_mm) : 60.0 * feed) + "\n";
}

void FiveAxisLines::comment(const char* key, double value, std::string& text) {
  char digits[32];
  text.append(key).append(digits, writeFixed<5>(digits, toUnits(value, 1e5))).append("\n");
}

void requireWritable(const ListedPath& listed) {
  if (listed.path->deposit == Deposit::Drops)
    refuseWaypoint(listed, 0, "drops are deposited; a five-axis program deposits beads only");
  requireWritableFeeds(listed);
}

/// A program and all that has to be known before its first line.
class FiveAxisProgram {
 public:
  FiveAxisProgram(const FiveAxisMotion& motion, const FiveAxisSettings& settings,
                  const ProgramSettings& program)
      : motion_(motion),
        settings_(settings),
        program_(program),
        letters_(axisLetters(motion.machine, settings.letters)),
        paths_(listedPaths(motion.toolpath)),
        rise_mm_((motion.bed_from_part.linear() * layerNormal(motion.toolpath))
                     .dot(motion.bed_from_part.translation())) {
    for (const ListedPath& path : paths_) requireWritable(path);
    requireOwnFeeder();
    validate(motion.toolpath);
    requireSupported(
        motion.toolpath,
        {ProcessElement::Dwell, ProcessElement::Fan, ProcessElement::Pause, ProcessElement::Code},
        "five-axis programs");
    stations_.emplace(motion.toolpath, motion.bed_from_part, motion.machine, motion.joints);
    requireTurns();
    if (settings.coordinates == FiveAxisCoordinates::Joints) findChords();
    start_code_ = expandCode("program.start_code", program.start_code, program, motion.bed_from_part);
    end_code_ = expandCode("program.end_code", program.end_code, program, motion.bed_from_part);
  }

  void write(const TextSink& sink) const {
    const bool has_joints = settings_.coordinates == FiveAxisCoordinates::Joints;
    FiveAxisLines lines(motion_.machine, settings_, program_);
    std::string text = head();
    const Path& first = *paths_.front().path;
    if (settings_.dialect == FiveAxisDialect::LinuxCnc) text += tipControlOff(settings_) + "\n";
    lines.approach(stations_->begin(0), motion_.bed_from_part * first.firstPoint(),
                   has_joints ? "" : tipControlOn(settings_), text);
    text += has_joints ? "G93\n" : "G94\n";
    bool is_retracted = false;
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      writePath(p, is_retracted, lines, text);
      if (text.size() < kTextPiece) continue;
      sink(text);
      text.clear();
    }
    for (const ToolpathEvent& event : motion_.toolpath.events_at_end)
      writeFiveAxisEvent(event, program_, text);
    text += "; end of the part\n";
    if (has_joints) text += "G94\n";
    if (settings_.dialect != FiveAxisDialect::Generic) lines.leave(settings_.retract_mm, text);
    if (!has_joints && !tipControlOff(settings_).empty()) text += tipControlEnd();
    sink(text + end_code_ + programEnd());
  }

 private:
  std::string tipControlEnd() const {
    const std::string before = beforeTipControlOff(settings_);
    const std::string off = tipControlOff(settings_) + "\n";
    // The line before may have left positions relative.
    return before.empty() ? off : before + "\n" + off + "G90\n";
  }

  std::string head() const {
    StatedFrame stated;
    stated.bed_from_layers =
        Eigen::Quaterniond(motion_.bed_from_part.linear()) * motion_.toolpath.part_from_layers;
    const bool has_joints = settings_.coordinates == FiveAxisCoordinates::Joints;
    const bool is_fanuc = settings_.dialect == FiveAxisDialect::Fanuc;
    const std::string part = oneLine(motion_.toolpath.part_name);
    return (is_fanuc ? "%\n" + fanucProgramName(settings_) + " ; " + part + "\n; generated by Lamina"
                     : "; generated by Lamina\n; part: " + part) +
           "\n;LAYER_COUNT:" + std::to_string(motion_.toolpath.layers.size()) +
           "\n;FIVE_AXIS:" + (has_joints ? "joints " : "tool_tip ") + toText(letters_) + "\n" +
           moduloComment() + frameComments(stated) + start_code_ + units() + "; start of the part\n";
  }

  std::string moduloComment() const {
    const std::string modulo = toText(moduloLetters(motion_.machine, settings_));
    return modulo.empty() ? "" : std::string(kModuloMark) + modulo + "\n";
  }

  /// Refuses what the words of rotary joints cannot state.
  void requireTurns() const {
    const std::vector<AxisLetter> modulo = moduloLetters(motion_.machine, settings_);
    const bool is_counted_by_fanuc = settings_.dialect == FiveAxisDialect::Fanuc && modulo.empty();
    if (modulo.empty() && !is_counted_by_fanuc) return;
    JointValues last = joints(0, 0);
    for (std::size_t p = 0; p < paths_.size(); ++p)
      for (std::size_t station = 0; station <= paths_[p].path->motionCount(); ++station) {
        const JointValues& next = joints(p, station);
        const std::size_t waypoint = station == 0 ? 0 : paths_[p].path->motionEnd(station - 1);
        if (is_counted_by_fanuc) requireCountedTurns(next, paths_[p], waypoint);
        for (const AxisLetter& axis : modulo)
          requireShorterWay(axis, toDegrees(std::abs(next[axis.joint] - last[axis.joint])), paths_[p],
                            waypoint);
        last = next;
      }
  }

  void requireCountedTurns(const JointValues& joints, const ListedPath& path, std::size_t waypoint) const {
    for (const AxisLetter& axis : letters_)
      if (axis.kind == JointKind::Rotary && std::abs(toDegrees(joints[axis.joint])) > kFarthestFanucAxis)
        refuseWaypoint(
            path, waypoint,
            std::string("axis ") + axis.letter + " is at " + numberText(toDegrees(joints[axis.joint])) +
                " deg; a Fanuc control takes 99 999.999 deg at most: expected an axis with rollover "
                "(parameter 1008#0) and five_axis.turns 'modulo'");
  }

  static void requireShorterWay(const AxisLetter& axis, double way_deg, const ListedPath& path,
                                std::size_t waypoint) {
    if (way_deg < 180.0) return;
    refuseWaypoint(path, waypoint,
                   std::string("axis ") + axis.letter + " turns by " + numberText(way_deg) +
                       " deg in one line; must be less than 180 with five_axis.turns 'modulo', by which the "
                       "control takes the shorter way");
  }

  /// Millimetres, absolute positions, and no material fed yet.
  std::string units() const {
    const FeederWord feeder = feederWord(settings_);
    if (!feeder.is_absolute) return "G21\nG90\nM83\nG92 E0\n";
    if (settings_.dialect == FiveAxisDialect::Siemens)
      return std::string("G71\nG90\nPRESETON(") + feeder.letter + ",0)\n";
    return std::string("G21\nG90\nG92 ") + feeder.letter + "0\n";
  }

  std::string programEnd() const {
    if (settings_.dialect == FiveAxisDialect::Generic) return "";
    if (settings_.dialect == FiveAxisDialect::LinuxCnc) return "G92.1\nM2\n";
    return settings_.dialect == FiveAxisDialect::Fanuc ? "M30\n%\n" : "M30\n";
  }

  void requireOwnFeeder() const {
    const char letter = feederWord(settings_).letter;
    for (const AxisLetter& axis : letters_)
      if (axis.letter == letter)
        throw InvalidConfig(std::string("five_axis.extrusion is ") + letter + ", an axis of '" +
                            motion_.machine.name() + "'; expected a letter beside " + toText(letters_));
  }

  const JointValues& joints(std::size_t p, std::size_t station) const {
    return station == 0 ? stations_->begin(p) : stations_->end(p, station - 1);
  }

  void findChords() {
    for (std::size_t p = 0; p < paths_.size(); ++p)
      for (std::size_t m = 0; m < paths_[p].path->motionCount(); ++m) {
        try {
          auto between =
              jointsBetween(motion_.machine, joints(p, m), joints(p, m + 1), settings_.chord_tolerance_mm);
          if (!between.empty()) chords_[{p, m}] = std::move(between);
        } catch (const Unreachable& error) {
          throw Unreachable(toText({paths_[p].layer, paths_[p].index, paths_[p].path->motionEnd(m)}) + ": " +
                            error.what());
        }
      }
  }

  void writeLayer(const ListedPath& listed, FiveAxisLines& lines, std::string& text) const {
    const ToolpathLayer& layer = motion_.toolpath.layers[listed.layer];
    text += ";LAYER:" + std::to_string(listed.layer) + "\n";
    lines.comment(";Z:", layer.z_mm + rise_mm_, text);
    lines.comment(";HEIGHT:", layer.height_mm, text);
  }

  void writePath(std::size_t p, bool& is_retracted, FiveAxisLines& lines, std::string& text) const {
    const Path& path = *paths_[p].path;
    if (p == 0 || paths_[p].layer != paths_[p - 1].layer) writeLayer(paths_[p], lines, text);
    const double length_mm = program_.retraction_length_mm;
    if (path.process.is_retracted && !is_retracted) lines.retract(-length_mm, text);
    lines.turn(joints(p, 0), text);
    if (path.role != PathRole::Travel) text.append(";TYPE:").append(toString(path.role)).append("\n");
    writeMotions(p, lines, text);
    const bool next_is_retracted = p + 1 < paths_.size() && paths_[p + 1].path->process.is_retracted;
    is_retracted = path.process.is_retracted && next_is_retracted;
    if (path.process.is_retracted && !is_retracted) lines.retract(length_mm, text);
  }

  void writeMotions(std::size_t p, FiveAxisLines& lines, std::string& text) const {
    const Path& path = *paths_[p].path;
    const PathExtrusion extrusion(path, filamentPerVolume(program_));
    double height_mm = motion_.toolpath.layers[paths_[p].layer].height_mm;
    bool is_stated = false;  // that of the layer may have been left by the path before
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      writeEvents(path, m, text);
      const std::size_t end = path.motionEnd(m);
      const double bead_mm = path.bead.at(end).height_mm;
      if (path.role != PathRole::Travel && (!is_stated || bead_mm != height_mm)) {
        lines.comment(";HEIGHT:", bead_mm, text);
        height_mm = bead_mm;
        is_stated = true;
      }
      writeMotion(p, m, extrusion, lines, text);
    }
    writeEvents(path, path.motionCount(), text);
  }

  void writeEvents(const Path& path, std::size_t motion, std::string& text) const {
    for (const PathEvent& placed : eventsBefore(path.events, motion))
      writeFiveAxisEvent(placed.event, program_, text);
  }

  void writeMotion(std::size_t p, std::size_t m, const PathExtrusion& extrusion, FiveAxisLines& lines,
                   std::string& text) const {
    const Path& path = *paths_[p].path;
    const std::size_t end = path.motionEnd(m);
    const double length_mm = (path.points[end] - path.points[m]).norm();
    if (length_mm == 0.0) return lines.turn(joints(p, m + 1), text);
    const auto found = chords_.find({p, m});
    FiveAxisTarget target;
    target.feed = path.feed_mm_s.at(end);
    target.remark = " ;via";
    const double filament_mm = extrusion.along(length_mm, end);
    double done = 0.0;
    const auto take = [&](double share) {
      target.filament_mm = filament_mm * (share - done);
      target.time_s = length_mm / target.feed * (share - done);
      done = share;
    };
    if (found != chords_.end())
      for (const JointsBetween& between : found->second) {
        take(between.share);
        target.joints = between.values;
        lines.move(target, text);
      }
    take(1.0);
    target.joints = joints(p, m + 1);
    target.tip = motion_.bed_from_part * path.points[end];
    target.remark = path.is_closed && end == 0 ? " ;close" : "";
    lines.move(target, text);
  }

  const FiveAxisMotion& motion_;
  const FiveAxisSettings& settings_;
  const ProgramSettings& program_;
  std::vector<AxisLetter> letters_;
  std::vector<ListedPath> paths_;
  double rise_mm_;
  std::optional<ProgramStations> stations_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<JointsBetween>> chords_;  ///< by path and motion
  std::string start_code_;
  std::string end_code_;
};

}  // namespace

void writeFiveAxis(const FiveAxisMotion& motion, const FiveAxisSettings& settings,
                   const ProgramSettings& program, const TextSink& sink) {
  if (program.arcs_tolerance_mm > 0.0) refuseArcs(program, "five-axis programs");
  const FiveAxisProgram written(motion, settings, program);
  if (settings.dialect != FiveAxisDialect::Fanuc) return written.write(sink);
  written.write([&](std::string_view lines) { sink(fanucText(lines)); });
}

}  // namespace lamina
