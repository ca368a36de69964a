// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/krl/krl_parser.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "lamina/base/text.hpp"
#include "lamina/program/robot/robot_angles.hpp"

namespace lamina {
namespace {

constexpr double kMillimetres = 1e3;  // in a metre
constexpr int kMostExternal = 6;
constexpr const char* kKrlCoordinate = "a coordinate within 100 m";
constexpr const char* kKrlAngle = "an angle in degrees";

/// Settings of the controller that change nothing that is read.
constexpr std::array<std::string_view, 10> kKrlPreparing = {"$ADVANCE", "$IPO_MODE", "$ORI_TYPE", "$TOOL",
                                                            "$LOAD",    "$BASE",     "$VEL.ORI1", "$VEL.ORI2",
                                                            "$ACC.CP",  "$APO.CDIS"};

std::vector<double> krlExternal(LineCursor& cursor) {
  std::vector<double> external;
  while (cursor.take(",")) {
    const std::string name = "E" + std::to_string(external.size() + 1);
    if (external.size() == kMostExternal) cursor.refuse("six external axes at most");
    cursor.expect(name);
    external.push_back(cursor.number(-kFarthestRead, kFarthestRead, "an external axis, in mm or deg"));
  }
  return external;
}

JointMove krlJoints(LineCursor& cursor) {
  JointMove move;
  cursor.expect("{");
  for (std::size_t j = 0; j < 6; ++j) {
    if (j > 0) cursor.expect(",");
    cursor.expect("A" + std::to_string(j + 1));
    move.joints.arm_deg[j] = cursor.number(-kGreatestAngle, kGreatestAngle, kKrlAngle);
  }
  move.joints.external = krlExternal(cursor);
  cursor.expect("}");
  return move;
}

/// Without its speed.
TipMove krlPose(LineCursor& cursor) {
  TipMove move;
  cursor.expect("{");
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) cursor.expect(",");
    cursor.expect(std::string(1, "XYZ"[axis]));
    move.point[axis] = cursor.number(-kFarthestRead, kFarthestRead, kKrlCoordinate);
  }
  RobotAngles angles;
  const std::array<std::pair<const char*, double*>, 3> turns = {
      {{"A", &angles.z_deg}, {"B", &angles.y_deg}, {"C", &angles.x_deg}}};
  for (const auto& [name, angle] : turns) {
    cursor.expect(",");
    cursor.expect(name);
    *angle = cursor.number(-kGreatestAngle, kGreatestAngle, kKrlAngle);
  }
  move.orientation = rotationOfAngles(angles);
  move.external = krlExternal(cursor);
  cursor.expect("}");
  return move;
}

/// Points by name, as written in capitals.
using KrlPointNames = std::map<std::string, TipMove>;

KrlPointNames krlPoints(const RobotSourceText& source) {
  KrlPointNames points;
  if (!source.data) return points;
  ReadFile file{source.data_file, {}};
  std::size_t number = 0;
  for (const std::string_view text : textLines(*source.data)) {
    LineCursor cursor(text, ++number, file);
    if (cursor.isAtEnd() || cursor.take(";") || cursor.take("&")) continue;
    if (!file.quotation.isRecognised()) {
      cursor.expect("DEFDAT");
      file.quotation.recognise();
      continue;
    }
    if (cursor.take("ENDDAT")) continue;
    cursor.expect("DECL");
    cursor.take("GLOBAL");
    cursor.expect("E6POS");
    const std::string name = lowerCase(cursor.word("the name of a point"));
    cursor.expect("=");
    if (!points.emplace(name, krlPose(cursor)).second) cursor.refuse(name, "each point once");
    cursor.expectEnd();
  }
  return points;
}

class KrlParser {
 public:
  explicit KrlParser(const RobotSourceText& source) : source_(source), file_{source.file, {}} {}

  std::vector<ReadStatement> parse() {
    std::size_t number = 0;
    bool is_ended = false;
    for (const std::string_view text : textLines(source_.text)) {
      LineCursor cursor(text, ++number, file_);
      if (cursor.isAtEnd()) continue;
      if (is_ended) cursor.refuse("nothing after END");
      if (cursor.take("&")) continue;
      if (cursor.take(";")) {
        keepArc(cursor.rest());
        list_.addComment(cursor.rest(), number);
        continue;
      }
      is_ended = cursor.take("END");
      if (is_ended && (list_.isConditionOpen() || is_speed_conditional_))
        cursor.refuse("END", "ENDIF before it");
      if (is_ended)
        cursor.expectEnd();
      else
        readLine(cursor);
    }
    LineCursor end("", number + 1, file_);
    if (!is_begun_) end.refuse("DEF, which begins a program");
    if (!is_ended) end.refuse("END");
    return list_.take();
  }

 private:
  void readLine(LineCursor& cursor) {
    if (!is_begun_) {
      cursor.expect("DEF");
      cursor.word("the name of a program");
      cursor.expect("(");
      cursor.expect(")");
      file_.quotation.recognise();
      cursor.expectEnd();
      is_begun_ = true;
      return;
    }
    if (const std::optional<bool> arc = arcOf(cursor.rest())) {
      list_.add(ArcSwitch{*arc}, cursor.line());
      return;
    }
    if (is_speed_conditional_ || isDrySpeed(cursor)) return readDrySpeed(cursor);
    if (cursor.take(kDryVariable)) {
      cursor.expect("=");
      return readFlag(cursor);
    }
    if (cursor.take("LIN"))
      add(cursor, linear(cursor));
    else if (cursor.take("PTP"))
      add(cursor, krlJoints(cursor));
    else if (cursor.take("TRIGGER"))
      readTrigger(cursor);
    else if (cursor.take("IF"))
      openCondition(cursor);
    else if (cursor.take("ENDIF"))
      closeCondition(cursor);
    else if (cursor.take("WAIT"))
      readWait(cursor);
    else if (cursor.take("BAS"))
      return;  // prepares the controller
    else if (cursor.take("$"))
      readAssignment(cursor);
    else
      readCall(cursor);
  }

  /// The statements of the arc package stand in notes.
  void keepArc(std::string_view comment) {
    const auto keep = [&](std::string_view note, std::string& text) {
      const std::string mark = "# " + std::string(note) + " ";
      if (comment.substr(0, mark.size()) == mark) text = std::string(trimmed(comment.substr(mark.size())));
    };
    keep(kArcOnNote, arc_on_);
    keep(kArcOffNote, arc_off_);
  }

  /// Whether a line starts an arc or ends it; nothing if it does neither.
  std::optional<bool> arcOf(std::string_view line) const {
    const std::string_view text = trimmed(line);
    if (!arc_on_.empty() && text == arc_on_) return true;
    if (!arc_off_.empty() && text == arc_off_) return false;
    return std::nullopt;
  }

  void add(LineCursor& cursor, RobotStatement statement) {
    cursor.expectEnd();
    list_.add(std::move(statement), cursor.line());
  }

  /// Whether the line declares the variable of a dry run's speed, or sets it.
  static bool isDrySpeed(LineCursor cursor) { return cursor.take("DECL") || cursor.take(kDrySpeedVariable); }

  /// The declaration, `lamina_speed=0.2`, or what stands in a condition for that alone.
  void readDrySpeed(LineCursor& cursor) {
    if (is_speed_conditional_ && cursor.take("ENDIF")) {
      is_speed_conditional_ = false;
    } else if (!is_speed_conditional_ && cursor.take("DECL")) {
      const bool is_flag = cursor.take("BOOL");
      if (!is_flag) cursor.expect("REAL");
      cursor.expect(is_flag ? kDryVariable : kDrySpeedVariable);
    } else {
      cursor.expect(kDrySpeedVariable);
      cursor.expect("=");
      cursor.number(0.0, 1.0, "a share of the speed, 0 to 1");
    }
    cursor.expectEnd();
  }

  /// `$FLAG[1]`, and nothing behind it.
  static void readFlag(LineCursor& cursor) {
    expectFlag(cursor);
    cursor.expectEnd();
  }

  static void expectFlag(LineCursor& cursor) {
    for (const char* text : {"$", "FLAG", "["}) cursor.expect(text);
    cursor.integer(1, kMostOutputs, "the number of a flag");
    cursor.expect("]");
  }

  /// `NOT $FLAG[1] THEN`, or `NOT lamina_dry THEN`; without NOT, for the speed of a dry run.
  void openCondition(LineCursor& cursor) {
    if (list_.isConditionOpen()) cursor.refuse("IF", "ENDIF before it");
    is_speed_conditional_ = !cursor.take("NOT");
    if (!is_speed_conditional_) list_.openDryCondition();
    if (is_speed_conditional_ || !cursor.take(kDryVariable)) expectFlag(cursor);
    cursor.expect("THEN");
    cursor.expectEnd();
  }

  void closeCondition(LineCursor& cursor) {
    if (!list_.closeDryCondition()) cursor.refuse("ENDIF", kOneSwitch);
    cursor.expectEnd();
  }

  TipMove linear(LineCursor& cursor) {
    if (speed_mm_s_ == 0.0) cursor.refuse("$VEL.CP=, a speed, before the first move");
    TipMove move;
    if (!cursor.isAtEnd() && cursor.rest().front() == '{') {
      move = krlPose(cursor);
    } else {
      const std::string name = lowerCase(cursor.word("a pose, or the name of a point"));
      // A data file that no move names may be of another program.
      if (!points_) points_ = krlPoints(source_);
      const auto found = points_->find(name);
      if (found == points_->end()) cursor.refuse(name, "a point of the data file");
      move = found->second;
    }
    move.feed_mm_s = speed_mm_s_;
    move.rests = !cursor.take("C_DIS");
    return move;
  }

  void readTrigger(LineCursor& cursor) {
    cursor.expect("WHEN");
    cursor.expect("DISTANCE");
    cursor.expect("=");
    cursor.expect("0");
    cursor.expect("DELAY");
    cursor.expect("=");
    cursor.number(-1e4, 1e4, "a delay in ms");
    cursor.expect("DO");
    cursor.expect("$");
    cursor.expect("ANOUT");
    add(cursor, level(cursor, true));
  }

  LevelChange level(LineCursor& cursor, bool is_on_the_way) {
    LevelChange change;
    change.output = indexOf(cursor);
    change.value = cursor.number(-kGreatestLevel, kGreatestLevel, "a value");
    change.is_on_the_way = is_on_the_way;
    return change;
  }

  /// `[1]=`.
  static int indexOf(LineCursor& cursor) {
    cursor.expect("[");
    const int index = cursor.integer(0, kMostOutputs, "the number of an output");
    cursor.expect("]");
    cursor.expect("=");
    return index;
  }

  void readWait(LineCursor& cursor) {
    cursor.expect("SEC");
    add(cursor, ProgramWait{cursor.number(0.0, kLongestWait, "a wait in s")});
  }

  void readAssignment(LineCursor& cursor) {
    if (cursor.take("VEL.CP")) {
      cursor.expect("=");
      speed_mm_s_ = kMillimetres * cursor.number(kSlowestRead / kMillimetres, kFastestRead / kMillimetres,
                                                 "a speed in m/s, above 0");
      if (cursor.take("*")) cursor.expect(kDrySpeedVariable);
      return cursor.expectEnd();
    }
    if (cursor.take("ANOUT")) return add(cursor, level(cursor, false));
    if (cursor.take("OUT")) {
      OutputSwitch output;
      output.output = indexOf(cursor);
      output.is_on = cursor.take("TRUE");
      if (!output.is_on) cursor.expect("FALSE");
      return add(cursor, output);
    }
    for (const std::string_view name : kKrlPreparing)
      if (cursor.take(name.substr(1))) return cursor.expect("=");
    if (cursor.take("ACT_EX_AX")) return cursor.expect("=");
    cursor.refuse("a variable of the controller that is known");
  }

  void readCall(LineCursor& cursor) {
    const std::string name = cursor.word("a statement that is known");
    if (!cursor.take("(")) cursor.refuse(name, "a statement that is known, or a call of a program");
    cursor.expect(")");
    add(cursor, FileCall{name});
  }

  const RobotSourceText& source_;
  ReadFile file_;
  std::optional<KrlPointNames> points_;  ///< of the data file, once a move names one
  StatementList list_;
  std::string arc_on_;  ///< empty where no note states it
  std::string arc_off_;
  bool is_begun_ = false;
  bool is_speed_conditional_ = false;  ///< within the condition of the speed of a dry run
  double speed_mm_s_ = 0.0;            ///< none yet
};

}  // namespace

std::vector<ReadStatement> parseKrl(const RobotSourceText& source) { return KrlParser(source).parse(); }

}  // namespace lamina
