// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/five_axis/five_axis_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/program/gcode/gcode_line.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/program/program_frame.hpp"
#include "program/five_axis/fanuc_text.hpp"
#include "program/five_axis/five_axis_events.hpp"
#include "program/five_axis/five_axis_letters.hpp"
#include "program/gcode/command_words.hpp"
#include "program/gcode/slicer_comments.hpp"

namespace lamina {
namespace {

constexpr std::string_view kMark = ";FIVE_AXIS:";
constexpr double kSamePlace = 0.01;  // mm: last decimals of all joints together
constexpr double kDegreesOfTurn = 360.0;
constexpr double kLargest = 1e7;    // mm, deg and their feeds
constexpr double kShortest = 1e12;  // 1/min: the least motion at the greatest feed that is written

/// Where the nozzle is, and which joints bring it there.
struct Held {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  JointValues joints;    ///< of size 0 where only the toolpath is asked for
  std::size_t line = 0;  ///< that says so
};

struct Turned {
  Held begin;
  Held end;
};

/// A place at which the nozzle is turned while its tip stays.
struct TurnInPlace {
  std::size_t before = 0;  ///< the motion of the nozzle that follows
  std::vector<Held> held;  ///< before it turns, and after each line
};

/// As a travel whose waypoints all lie at the tip.
Path pathOf(const TurnInPlace& turn, const Path& following) {
  Path path;
  path.role = PathRole::Travel;
  path.process.is_retracted = following.process.is_retracted;
  path.tool = following.tool;
  path.points.assign(turn.held.size(), following.firstPoint());
  std::vector<Eigen::Quaterniond> each;
  each.reserve(turn.held.size());
  for (const Held& held : turn.held) each.push_back(held.turn);
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  path.feed_mm_s = following.feed_mm_s.at(following.motionEnd(0));
  return path;
}

/// Which lines become waypoints.
enum class LinesTaken : std::uint8_t {
  Waypoints,  ///< those of the toolpath that was written
  All,        ///< those in between, too, with the joints of each
};

/// A word's value; F and E too.
struct Words {
  std::optional<double> g;
  std::optional<double> e;
  std::optional<double> f;
  bool has_axis = false;
};

/// The lines of a part, one after the other.
class FiveAxisInterpreter {
 public:
  FiveAxisInterpreter(const KinematicModel& machine, const FiveAxisSettings& settings,
                      const ProgramSettings& filament, LinesTaken taken)
      : machine_(machine),
        settings_(settings),
        taken_(taken),
        letters_(axisLetters(machine, settings.letters)),
        program_(filament),
        feeder_(feederWord(settings)),
        builder_(filament),
        values_(letters_.size(), std::numeric_limits<double>::quiet_NaN()) {}

  void readLine(std::string_view text, std::size_t number) {
    line_ = number;
    if (text.substr(0, kMark.size()) == kMark) return readAxes(text.substr(kMark.size()));
    if (!is_in_part_ && text.substr(0, kModuloMark.size()) == kModuloMark)
      return readModulo(text.substr(kModuloMark.size()));
    if (text == "; start of the part") return startPart();
    if (text == "; end of the part") is_in_part_ = false, is_over_ = true;
    if (!is_in_part_) {
      if (!text.empty() && text.front() == ';') builder_.readComment(text.substr(1));
      return;
    }
    if (!modulo_.empty()) text = plain_ = withoutDirections(text);
    const GcodeLine& line = parser_.parse(text, number);
    remark_ = line.words.empty() || line.comments.empty() ? "" : line.comments.front();
    if (line.words.empty())
      for (const std::string_view comment : line.comments) readRemark(comment);
    if (isCommand(line.command, "G4")) return readCommand(line.command);
    if (line.is_other) return readCommand(line.command);
    if (!line.words.empty()) readMotion(line);
  }

  Toolpath finish(const std::string& part_name) {
    if (!is_over_)
      throw InvalidProgram("'" + part_name + "' has no '; end of the part'; expected whole programs");
    Toolpath toolpath = builder_.finish(part_name);
    if (toolpath.layers.empty())
      throw InvalidProgram("'" + part_name + "' has no motion; expected a program that prints");
    return oriented(std::move(toolpath));
  }

  /// @param toolpath  as finished
  StatedMotion stated(Toolpath toolpath) {
    StatedMotion motion;
    std::size_t next = 0;
    auto in_place = in_place_.begin();
    const auto add = [&](const WaypointIndex& at, Held& held) {
      motion.joints.at.push_back(at);
      motion.joints.values.push_back(std::move(held.joints));
      motion.lines.push_back(held.line);
    };
    for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
      std::vector<Path> paths;
      paths.reserve(toolpath.layers[l].paths.size());
      for (Path& path : toolpath.layers[l].paths) {
        // After a turn in place, a path begins.
        if (in_place != in_place_.end() && in_place->before == next) {
          paths.push_back(pathOf(*in_place, path));
          for (std::size_t w = 0; w < in_place->held.size(); ++w)
            add({l, paths.size() - 1, w}, in_place->held[w]);
          ++in_place;
        }
        const std::size_t p = paths.size();
        add({l, p, 0}, turns_[next].begin);
        for (std::size_t m = 0; m < path.motionCount(); ++m)
          add({l, p, path.motionEnd(m)}, turns_[next++].end);
        paths.push_back(std::move(path));
      }
      toolpath.layers[l].paths = std::move(paths);
    }
    motion.toolpath = std::move(toolpath);
    return motion;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidProgram("line " + std::to_string(line_) + ": " + what);
  }

  void readAxes(std::string_view stated) {
    const std::size_t space = std::min(stated.find(' '), stated.size());
    const std::string_view kind = stated.substr(0, space);
    if (kind != "joints" && kind != "tool_tip")
      refuse("found '" + std::string(kind) + "'; expected joints or tool_tip");
    has_joints_ = kind == "joints";
    const std::string axes(stated.substr(std::min(space + 1, stated.size())));
    if (axes != toText(letters_))
      refuse("the program has the axes '" + axes + "'; expected those of '" + machine_.name() + "', " +
             toText(letters_));
    has_axes_ = true;
  }

  void readModulo(std::string_view letters) {
    for (const char letter : letters) {
      if (letter == ' ') continue;
      const auto found = std::find_if(letters_.begin(), letters_.end(), [&](const AxisLetter& axis) {
        return axis.letter == letter && axis.kind == JointKind::Rotary;
      });
      if (found == letters_.end())
        refuse(std::string("found ") + letter + " among the axes within one turn; expected rotary ones of " +
               toText(letters_));
      modulo_ += letter;
    }
  }

  /// `C=DC(12.5)` as `C12.5`: the shorter way is that of any axis within one turn.
  static std::string withoutDirections(std::string_view line) {
    constexpr std::string_view kShorterWay = "=DC(";
    std::string text(line);
    const std::size_t remark = std::min(text.find(';'), text.size());
    for (std::size_t at = text.find(kShorterWay); at < remark; at = text.find(kShorterWay, at)) {
      const std::size_t close = text.find(')', at);
      if (close == std::string::npos) break;
      text.erase(close, 1);
      text.erase(at, kShorterWay.size());
    }
    return text;
  }

  void startPart() {
    if (!has_axes_) refuse("the part starts; expected '" + std::string(kMark) + "' before it");
    is_in_part_ = true;
  }

  void readRemark(std::string_view comment) {
    const std::size_t section = context_.section;
    readComment(comment, context_);
    if (context_.section != section) path_begin_ = nozzle_;
  }

  void readCommand(std::string_view command) {
    if (command == "G93" || command == "G94") {
      has_inverse_time_ = command == "G93";
    } else if (auto event = eventOf(command)) {
      builder_.add(std::move(*event));
    } else if (command != tipControlOn(settings_) && command != tipControlOff(settings_)) {
      refuse("found '" + std::string(command.substr(0, 40)) +
             "'; expected G0, G1, G93, G94, G4 or what turns tool-tip coordinates on or off");
    }
  }

  std::optional<ToolpathEvent> eventOf(std::string_view command) const {
    try {
      return readFiveAxisEvent(command, program_);
    } catch (const InvalidProgram& error) {
      refuse(error.what());
    }
  }

  Words readWords(const GcodeLine& line) {
    Words words;
    for (const GcodeWord& word : line.words) {
      const double most = word.letter == 'F' && has_inverse_time_ ? kShortest : kLargest;
      if (!word.value || !(std::abs(*word.value) <= most))
        refuse(std::string("the word ") + word.letter + " has no value within " +
               (most > kLargest ? "1e12" : "1e7") + "; expected a number");
      std::optional<double>* known = word.letter == 'G'              ? &words.g
                                     : word.letter == feeder_.letter ? &words.e
                                     : word.letter == 'F'            ? &words.f
                                                                     : nullptr;
      if (known != nullptr) {
        if (known->has_value()) refuse(std::string("the word ") + word.letter + " stands twice");
        *known = word.value;
      } else {
        setAxis(word.letter, *word.value);
        words.has_axis = true;
      }
    }
    // An axis says where it goes to; a word E says by how much.
    if (words.e && feeder_.is_absolute) {
      const double fed_mm = *words.e;
      words.e = fed_mm - fed_mm_;
      fed_mm_ = fed_mm;
    }
    return words;
  }

  void setAxis(char letter, double value) {
    for (std::size_t i = 0; i < letters_.size(); ++i)
      if (letters_[i].letter == letter) {
        const bool is_modulo = modulo_.find(letter) != std::string::npos && !std::isnan(values_[i]);
        values_[i] =
            is_modulo ? value + kDegreesOfTurn * std::round((values_[i] - value) / kDegreesOfTurn) : value;
        return;
      }
    refuse(std::string("found the word ") + letter + "; expected G, " + feeder_.letter +
           ", F or an axis of " + toText(letters_));
  }

  /// Joints as they are written; linear ones are zero where the words are those of the tip.
  JointValues writtenJoints() const {
    JointValues joints = JointValues::Zero(static_cast<Eigen::Index>(letters_.size()));
    for (std::size_t i = 0; i < letters_.size(); ++i) {
      if (std::isnan(values_[i]))
        refuse(std::string("axis ") + letters_[i].letter + " has no value yet; expected one before it moves");
      const bool is_linear = letters_[i].kind == JointKind::Linear;
      if (!is_linear) joints[letters_[i].joint] = toRadians(values_[i]);
      if (is_linear && has_joints_) joints[letters_[i].joint] = values_[i];
    }
    return joints;
  }

  /// @return the nozzle over the bed [mm]
  Eigen::Isometry3d pose() const {
    Eigen::Isometry3d bed_from_nozzle = machine_.bedFromNozzle(writtenJoints());
    if (!has_joints_) bed_from_nozzle.translation() = Point3(values_[0], values_[1], values_[2]);
    return bed_from_nozzle;
  }

  /// Where the linear joints bring the tip, once the rotary ones stand as written: what tip control does.
  JointValues joints() const {
    JointValues joints = writtenJoints();
    if (has_joints_) return joints;
    const Jacobian rates = machine_.jacobian(joints);
    Eigen::Matrix3d directions;
    for (Eigen::Index i = 0; i < 3; ++i)
      directions.col(i) = rates.col(letters_[static_cast<std::size_t>(i)].joint).head<3>();
    const Point3 tip(values_[0], values_[1], values_[2]);
    const Point3 way = directions.inverse() * (tip - machine_.bedFromNozzle(joints).translation());
    for (Eigen::Index i = 0; i < 3; ++i) joints[letters_[static_cast<std::size_t>(i)].joint] = way[i];
    return joints;
  }

  Held held() const {
    Held held;
    held.turn = Eigen::Quaterniond(pose().linear());
    held.line = line_;
    if (taken_ == LinesTaken::All) held.joints = joints();
    return held;
  }

  void readMotion(const GcodeLine& line) {
    const Words words = readWords(line);
    if (!words.g || (*words.g != 0.0 && *words.g != 1.0)) refuse("found another motion; expected G0 or G1");
    if (*words.g == 0.0) return approach();
    if (words.f && !(*words.f > 0.0))
      refuse("the feed is " + numberText(*words.f) + "; expected more than 0");
    if (words.f) feed_ = *words.f;
    if (!words.f && (has_inverse_time_ || !feed_)) refuse("a motion has no F; expected one");
    if (!words.has_axis) return readFilament(words);
    if (!is_placed_) refuse("a motion before any position; expected an approach by G0");
    if (remark_ == "turn") return turnInPlace();
    filament_mm_ += words.e.value_or(0.0);
    Point3 tip = pose().translation();
    time_s_ += has_inverse_time_ ? 60.0 / *feed_ : (tip - between_).norm() / (*feed_ / 60.0);
    way_mm_ += (tip - between_).norm();
    between_ = tip;
    if (remark_ == "via" && taken_ == LinesTaken::Waypoints) return;
    if (remark_ == "close") tip = closing(tip);
    const double feed_mm_s = time_s_ > 0.0 ? std::max(way_mm_ / time_s_, 1e-9) : *feed_ / 60.0;
    const Turned turned = {held_, held()};
    if (tip != nozzle_) turns_.push_back(turned);
    held_ = turned.end;
    addMotion(tip, filament_mm_, feed_mm_s);
    filament_mm_ = time_s_ = way_mm_ = 0.0;
  }

  void turnInPlace() {
    if (in_place_.empty() || in_place_.back().before != turns_.size())
      in_place_.push_back({turns_.size(), {held_}});
    held_ = held();
    in_place_.back().held.push_back(held_);
    addMotion(nozzle_, 0.0, 1.0);
  }

  /// The last of its lines, before which no layer is reported, gives the place that the first motion starts
  /// from.
  void approach() {
    for (const double value : values_)
      if (std::isnan(value)) return;
    if (context_.layer) refuse("found G0 amid the part; expected G1");
    const Eigen::Isometry3d bed_from_nozzle = pose();
    between_ = bed_from_nozzle.translation();
    nozzle_ = between_;
    is_placed_ = true;
    held_ = held();
  }

  /// Where the path began, which joints reach but for their last decimals.
  Point3 closing(const Point3& tip) const {
    const double off_mm = (tip - path_begin_).norm();
    if (!(off_mm <= kSamePlace))
      refuse("a path closes " + numberText(off_mm) + " mm off its start; expected it to return");
    return path_begin_;
  }

  void readFilament(const Words& words) {
    if (!words.e) refuse("a motion of nothing; expected an axis or E");
    if (!is_placed_) refuse("a motion before any position; expected an approach by G0");
    addMotion(nozzle_, *words.e, 1.0);
  }

  void addMotion(const Point3& tip, double filament_mm, double feed_mm_s) {
    GcodeMotion motion = motionIn(context_);
    motion.start = nozzle_;
    motion.end = tip;
    motion.extrusion_mm = filament_mm;
    motion.feed_mm_s = feed_mm_s;
    motion.line = line_;
    if (!context_.layer) refuse("a motion before the first layer; expected ';LAYER:' before it");
    builder_.add(motion);
    nozzle_ = tip;
  }

  /// The builder makes a motion of each that the nozzle made, in their order.
  Toolpath oriented(Toolpath toolpath) const {
    std::size_t next = 0;
    for (ToolpathLayer& layer : toolpath.layers)
      for (Path& path : layer.paths) {
        std::vector<Eigen::Quaterniond> each(path.points.size());
        each.front() = turns_[next].begin.turn;
        for (std::size_t m = 0; m < path.motionCount(); ++m)
          each[path.motionEnd(m)] = turns_[next++].end.turn;
        path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
      }
    return toolpath;
  }

  const KinematicModel& machine_;
  const FiveAxisSettings& settings_;
  LinesTaken taken_;
  std::vector<AxisLetter> letters_;
  const ProgramSettings& program_;
  FeederWord feeder_;
  double fed_mm_ = 0.0;  ///< since the start of the part, of a feeder that is an axis
  ToolpathBuilder builder_;
  GcodeLineParser parser_;
  std::string plain_;   ///< the line that is read
  std::string modulo_;  ///< letters of axes whose words stand within one turn
  SlicerContext context_;
  std::vector<double> values_;  ///< of the words [mm, deg]
  std::vector<Turned> turns_;   ///< of each motion of the nozzle
  std::vector<TurnInPlace> in_place_;
  std::size_t line_ = 0;
  std::string_view remark_;
  bool has_axes_ = false;
  bool has_joints_ = false;
  bool has_inverse_time_ = false;
  bool is_in_part_ = false;
  bool is_over_ = false;
  std::optional<double> feed_;
  bool is_placed_ = false;
  Point3 nozzle_ = Point3::Zero();
  Point3 path_begin_ = Point3::Zero();
  Point3 between_ = Point3::Zero();
  Held held_;
  double filament_mm_ = 0.0;  ///< since the last waypoint
  double time_s_ = 0.0;
  double way_mm_ = 0.0;
};

/// Programs of that dialect alone begin so.
bool isFanucText(std::string_view program) { return !program.empty() && program.front() == '%'; }

void readLines(std::string_view program, FiveAxisInterpreter& interpreter) {
  const bool is_fanuc = isFanucText(program);
  for (std::size_t line = 1; !program.empty(); ++line) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    std::string_view text = program.substr(0, end);
    program.remove_prefix(std::min(end + 1, program.size()));
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    if (is_fanuc)
      interpreter.readLine(fromFanucText(text), line);
    else
      interpreter.readLine(text, line);
  }
}

}  // namespace

bool isFiveAxisProgram(std::string_view program) {
  if (isFanucText(program)) {
    const std::string_view head = program.substr(0, program.find("(START OF THE PART)"));
    return head.find("\n(FIVE_AXIS:") != std::string_view::npos;
  }
  const std::string_view head = program.substr(0, program.find("; start of the part"));
  return head.find("\n" + std::string(kMark)) != std::string_view::npos;
}

Toolpath readFiveAxis(std::string_view program, const KinematicModel& machine,
                      const FiveAxisSettings& settings, const ProgramSettings& filament,
                      const std::string& part_name) {
  FiveAxisInterpreter interpreter(machine, settings, filament, LinesTaken::Waypoints);
  readLines(program, interpreter);
  return interpreter.finish(part_name);
}

StatedMotion readFiveAxisMotion(std::string_view program, const KinematicModel& machine,
                                const FiveAxisSettings& settings, const ProgramSettings& filament,
                                const std::string& part_name) {
  FiveAxisInterpreter interpreter(machine, settings, filament, LinesTaken::All);
  readLines(program, interpreter);
  Toolpath toolpath = interpreter.finish(part_name);
  return interpreter.stated(std::move(toolpath));
}

}  // namespace lamina
