// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/urscript/urscript_parser.hpp"

#include <array>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/program/robot/robot_angles.hpp"

namespace lamina {
namespace {

constexpr double kUrMillimetres = 1e3;    // in a metre
constexpr double kGreatestUrAngle = 1e3;  // rad
constexpr double kGreatestUrRate = 1e6;   // of accelerations and joint speeds
constexpr const char* kUrRate = "a number above 0";

/// `p[x, y, z, rx, ry, rz]`.
TipMove urPoseOf(LineCursor& cursor) {
  TipMove move;
  cursor.expect("p");
  cursor.expect("[");
  Eigen::Vector3d turn;
  const double farthest_m = kFarthestRead / kUrMillimetres;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) cursor.expect(",");
    move.point[axis] =
        kUrMillimetres * cursor.number(-farthest_m, farthest_m, "a coordinate within 100 m, in m");
  }
  for (int axis = 0; axis < 3; ++axis) {
    cursor.expect(",");
    turn[axis] = cursor.number(-kGreatestUrAngle, kGreatestUrAngle, "an angle in rad");
  }
  cursor.expect("]");
  move.orientation = rotationOfVector(turn);
  move.is_over_base = true;
  return move;
}

double urNamed(LineCursor& cursor, const char* name, double low, double high, const char* expected) {
  cursor.expect(",");
  cursor.expect(name);
  cursor.expect("=");
  return cursor.number(low, high, expected);
}

class UrScriptParser {
 public:
  explicit UrScriptParser(const RobotSourceText& source) : source_(source), file_{source.file, {}} {}

  std::vector<ReadStatement> parse() {
    std::size_t number = 0;
    for (const std::string_view text : textLines(source_.text)) {
      LineCursor cursor(text, ++number, file_);
      if (cursor.isAtEnd()) continue;
      if (cursor.take("#"))
        list_.addComment(cursor.rest(), number);
      else
        readLine(cursor);
    }
    LineCursor end("", number + 1, file_);
    if (place_ == Place::Before) end.refuse("def, which begins a program");
    if (place_ == Place::Within) end.refuse("end");
    return list_.take();
  }

 private:
  enum class Place : std::uint8_t { Before, Within, After };

  void readLine(LineCursor& cursor) {
    switch (place_) {
      case Place::Before:
        cursor.expect("def");
        cursor.word("the name of a program");
        cursor.expect("(");
        cursor.expect(")");
        cursor.expect(":");
        file_.quotation.recognise();
        place_ = Place::Within;
        break;
      case Place::Within:
        if (is_speed_conditional_)
          readDrySpeed(cursor);
        else if (cursor.take("end"))
          readEnd(cursor);
        else if (cursor.take("if"))
          openCondition(cursor);
        else if (cursor.take("global"))
          readFlag(cursor);
        else
          readStatement(cursor);
        break;
      case Place::After:
        cursor.refuse("nothing after end");
    }
    cursor.expectEnd();
  }

  /// Of a condition, or of the program.
  void readEnd(LineCursor& cursor) {
    if (!is_conditional_)
      place_ = Place::After;
    else if (!list_.closeDryCondition())
      cursor.refuse("end", kOneSwitch);
    is_conditional_ = false;
  }

  void openCondition(LineCursor& cursor) {
    if (is_conditional_) cursor.refuse("if", "the end of the condition before it");
    is_speed_conditional_ = !cursor.take("not");
    is_conditional_ = !is_speed_conditional_;
    if (is_conditional_) list_.openDryCondition();
    cursor.expect("lamina_dry");
    cursor.expect(":");
  }

  /// What a dry run sets its speed to, or the end of that.
  void readDrySpeed(LineCursor& cursor) {
    is_speed_conditional_ = !cursor.take("end");
    if (is_speed_conditional_) readShare(cursor);
  }

  /// `lamina_speed = 0.2`.
  static void readShare(LineCursor& cursor) {
    cursor.expect(kDrySpeedVariable);
    cursor.expect("=");
    cursor.number(0.0, 1.0, "a share of the speed, 0 to 1");
  }

  /// `lamina_dry = False`, or True where the program was last run dry; or the share of a dry run's speed.
  static void readFlag(LineCursor& cursor) {
    if (LineCursor(cursor).take(kDrySpeedVariable)) return readShare(cursor);
    cursor.expect("lamina_dry");
    cursor.expect("=");
    if (!cursor.take("True")) cursor.expect("False");
  }

  void readStatement(LineCursor& cursor) {
    const std::string name = cursor.word("a statement that is known");
    if (!cursor.take("(")) cursor.refuse(name, "a statement that is known");
    if (name == "movej") {
      list_.add(joints(cursor), cursor.line());
    } else if (name == "movel" || name == "movep") {
      list_.add(move(cursor), cursor.line());
    } else if (name == "set_standard_digital_out") {
      list_.add(output(cursor), cursor.line());
    } else if (name == "set_standard_analog_out") {
      list_.add(level(cursor), cursor.line());
    } else if (name == "sleep") {
      list_.add(ProgramWait{cursor.number(0.0, kLongestWait, "a wait in s")}, cursor.line());
    } else if (name == "set_tcp") {
      list_.add(tool(cursor), cursor.line());
    } else if (name == "set_payload") {
      list_.add(payload(cursor), cursor.line());
    } else if (name != "sync") {
      cursor.refuse(
          name,
          "a statement that is known: movej, movel, movep, set_tcp, set_payload, set_standard_digital_out, "
          "set_standard_analog_out, sleep, sync");
    }
    cursor.expect(")");
  }

  static ToolStatement tool(LineCursor& cursor) {
    const TipMove tip = urPoseOf(cursor);
    Eigen::Isometry3d frame(tip.orientation);
    frame.translation() = tip.point;
    ToolStatement statement;
    statement.flange_from_tip = frame;
    return statement;
  }

  /// `2.5, [0, 0, 0.1]`.
  static ToolStatement payload(LineCursor& cursor) {
    ToolStatement statement;
    statement.mass_kg = cursor.number(0.0, kFarthestRead, "a mass in kg");
    cursor.expect(",");
    cursor.expect("[");
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) cursor.expect(",");
      statement.centre_mm[axis] =
          kUrMillimetres * cursor.number(-kFarthestRead, kFarthestRead, "a coordinate in m");
    }
    cursor.expect("]");
    return statement;
  }

  static JointMove joints(LineCursor& cursor) {
    JointMove move;
    cursor.expect("[");
    for (std::size_t j = 0; j < 6; ++j) {
      if (j > 0) cursor.expect(",");
      move.joints.arm_deg[j] =
          toDegrees(cursor.number(-kGreatestUrAngle, kGreatestUrAngle, "a joint's angle in rad"));
    }
    cursor.expect("]");
    urNamed(cursor, "a", 0.0, kGreatestUrRate, kUrRate);
    urNamed(cursor, "v", 0.0, kGreatestUrRate, kUrRate);
    return move;
  }

  static TipMove move(LineCursor& cursor) {
    TipMove move = urPoseOf(cursor);
    urNamed(cursor, "a", 0.0, kGreatestUrRate, kUrRate);
    move.feed_mm_s = kUrMillimetres * urNamed(cursor, "v", kSlowestRead / kUrMillimetres,
                                              kFastestRead / kUrMillimetres, "a speed in m/s, above 0");
    if (cursor.take("*")) cursor.expect(kDrySpeedVariable);
    move.rests = urNamed(cursor, "r", 0.0, kFarthestRead, "a radius in m") == 0.0;
    return move;
  }

  static OutputSwitch output(LineCursor& cursor) {
    OutputSwitch output;
    output.output = cursor.integer(0, kMostOutputs, "the number of an output");
    cursor.expect(",");
    output.is_on = cursor.take("True");
    if (!output.is_on) cursor.expect("False");
    return output;
  }

  static LevelChange level(LineCursor& cursor) {
    LevelChange level;
    level.output = cursor.integer(0, kMostOutputs, "the number of an output");
    cursor.expect(",");
    level.value = cursor.number(0.0, 1.0, "a share of 0 to 1");
    return level;
  }

  const RobotSourceText& source_;
  ReadFile file_;
  StatementList list_;
  Place place_ = Place::Before;
  bool is_conditional_ = false;        ///< within a condition of a dry run
  bool is_speed_conditional_ = false;  ///< within the condition of its speed
};

}  // namespace

std::vector<ReadStatement> parseUrScript(const RobotSourceText& source) {
  return UrScriptParser(source).parse();
}

}  // namespace lamina
