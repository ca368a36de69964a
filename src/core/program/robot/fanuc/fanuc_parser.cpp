// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/fanuc/fanuc_parser.hpp"

#include <array>
#include <map>
#include <utility>
#include <variant>

#include "lamina/program/robot/robot_angles.hpp"
#include "program/robot/reader/line_sequence.hpp"

namespace lamina {
namespace {

constexpr int kMostFanucPoints = 1000000;
constexpr double kGreatestFanucSpeed = 1e6;  // in any unit
constexpr std::string_view kWeldSpeedNote = "# weld_speed ";
constexpr const char* kFanucAngle = "an angle in degrees";
constexpr const char* kFanucCoordinate = "a coordinate within 100 m, in mm";

using FanucPoint = std::variant<JointMove, TipMove>;

/// Reads text across lines.
class FanucText : public LineSequence {
 public:
  FanucText(std::vector<std::string_view> lines, const ReadFile& file, std::size_t begin = 0)
      : LineSequence(std::move(lines), file, begin), cursor_("", 1, file) {}

  /// The line that holds what comes next.
  LineCursor& here() {
    while (cursor_.isAtEnd() && !isAtEnd()) cursor_ = nextLine();
    return cursor_;
  }

 private:
  LineCursor cursor_;
};

/// `1:HOME]`, or `1:"HOME"]`: what somebody called a point at the pendant says nothing of it.
int pointNumber(LineCursor& line) {
  const int number = line.integer(1, kMostFanucPoints, "the number of a point");
  if (line.take(":")) {
    const std::string_view rest = line.rest();
    const std::size_t end = rest.find(']');
    if (end == std::string_view::npos) line.refuse("']' behind the name of a point");
    line = LineCursor(rest.substr(end), line.line(), line.file());
  }
  line.expect("]");
  return number;
}

void readFrames(FanucText& text) {
  for (const char* name : {"UF", "UT"}) {
    text.here().expect(name);
    text.here().expect(":");
    text.here().integer(0, 99, "the number of a frame");
    text.here().expect(",");
  }
}

double measured(FanucText& text, const std::string& name, double limit, const char* unit,
                const char* expected) {
  text.here().expect(name);
  text.here().expect("=");
  const double value = text.here().number(-limit, limit, expected);
  text.here().expect(unit);
  return value;
}

/// `'N U T, 0, 0, 0',`: which way the arm stands follows from the motion.
void readConfiguration(FanucText& text) {
  text.here().expect(":");
  text.here().expect("'");
  const std::array<std::array<const char*, 2>, 3> letters = {{{"F", "N"}, {"U", "D"}, {"T", "B"}}};
  for (const auto& [one, other] : letters)
    if (!text.here().take(one)) text.here().expect(other);
  while (text.here().take(",")) text.here().integer(-99, 99, "a number of turns");
  text.here().expect("'");
  text.here().expect(",");
}

FanucPoint fanucJoints(FanucText& text) {
  JointMove move;
  for (std::size_t j = 0; j < 6; ++j) {
    if (j > 0) text.here().expect(",");
    move.joints.arm_deg[j] = measured(text, "J" + std::to_string(j + 1), kGreatestAngle, "deg", kFanucAngle);
  }
  return move;
}

FanucPoint fanucPose(FanucText& text) {
  TipMove move;
  for (int axis = 0; axis < 3; ++axis) {
    move.point[axis] = measured(text, std::string(1, "XYZ"[axis]), kFarthestRead, "mm", kFanucCoordinate);
    text.here().expect(",");
  }
  RobotAngles angles;
  angles.x_deg = measured(text, "W", kGreatestAngle, "deg", kFanucAngle);
  text.here().expect(",");
  angles.y_deg = measured(text, "P", kGreatestAngle, "deg", kFanucAngle);
  text.here().expect(",");
  angles.z_deg = measured(text, "R", kGreatestAngle, "deg", kFanucAngle);
  move.orientation = rotationOfAngles(angles);
  return move;
}

std::vector<double> fanucExternal(FanucText& text) {
  std::vector<double> external;
  while (text.here().take(",")) {
    if (external.size() == 3) text.here().refuse("three rails at most");
    external.push_back(measured(text, "E" + std::to_string(external.size() + 1), kFarthestRead, "mm",
                                "an external axis in mm"));
  }
  if (!text.here().take("GP2")) return external;
  text.here().expect(":");
  readFrames(text);
  for (std::size_t turn = 1; turn == 1 || text.here().take(","); ++turn) {
    if (turn > 3) text.here().refuse("three turning axes at most");
    external.push_back(measured(text, "J" + std::to_string(turn), kGreatestAngle, "deg", kFanucAngle));
  }
  return external;
}

/// `P[3]{ ... };`.
std::pair<int, FanucPoint> fanucPoint(FanucText& text) {
  text.here().expect("P");
  text.here().expect("[");
  const int number = pointNumber(text.here());
  text.here().expect("{");
  text.here().expect("GP1");
  text.here().expect(":");
  readFrames(text);
  const bool is_pose = text.here().take("CONFIG");
  if (is_pose) readConfiguration(text);
  FanucPoint point = is_pose ? fanucPose(text) : fanucJoints(text);
  std::vector<double> external = fanucExternal(text);
  if (auto* joints = std::get_if<JointMove>(&point))
    joints->joints.external = std::move(external);
  else
    std::get<TipMove>(point).external = std::move(external);
  text.here().expect("}");
  text.here().expect(";");
  return {number, std::move(point)};
}

class FanucParser {
 public:
  explicit FanucParser(const RobotSourceText& source)
      : file_{source.file, {}}, text_(textLines(source.text), file_) {}

  std::vector<ReadStatement> parse() {
    readName();
    readPoints();
    readHead();
    readLines();
    return list_.take();
  }

 private:
  void readName() {
    if (text_.isAtEnd()) text_.end().refuse("/PROG");
    text_.nextLine().expect("/PROG");
    file_.quotation.recognise();
  }

  void readHead() {
    while (!text_.isAtEnd()) {
      LineCursor line = text_.nextLine();
      if (line.take("/MN")) return line.expectEnd();
    }
    text_.end().refuse("/MN, which begins the statements");
  }

  void readLines() {
    while (!text_.isAtEnd()) {
      LineCursor line = text_.nextLine();
      if (line.isAtEnd()) continue;
      if (line.take("/POS")) {
        if (list_.isConditionOpen()) line.refuse("/POS", "the label of the jump before it");
        return line.expectEnd();
      }
      // What goes on with the line before has no number.
      if (line.take(":")) {
        list_.add(arc(line), line.line());
        endStatement(line);
        continue;
      }
      line.integer(1, kMostFanucPoints, "the number of a line, or /POS");
      line.expect(":");
      if (line.take(";")) {
        line.expectEnd();
        continue;
      }
      if (!line.take("!"))
        readStatement(line);
      else
        readComment(line);
    }
    text_.end().refuse("/POS, which begins the points");
  }

  void readComment(LineCursor& line) {
    std::string_view comment = line.rest();
    const std::size_t semicolon = comment.rfind(';');
    if (semicolon == std::string_view::npos) line.refuse("a semicolon at the end of the line");
    comment = comment.substr(0, semicolon);
    while (!comment.empty() && comment.back() == ' ') comment.remove_suffix(1);
    if (comment.substr(0, kWeldSpeedNote.size()) == kWeldSpeedNote) {
      LineCursor stated(comment.substr(kWeldSpeedNote.size()), line.line(), file_);
      weld_mm_s_ = stated.number(1e-3, kGreatestFanucSpeed, "the speed of welds in mm/s");
      return stated.expectEnd();
    }
    list_.addComment(comment, line.line());
  }

  /// A move may end on the next line.
  static void endStatement(LineCursor& line) {
    line.expect(";");
    line.expectEnd();
  }

  static ArcSwitch arc(LineCursor& line) {
    line.expect("Arc");
    ArcSwitch arc;
    arc.is_on = line.take("Start");
    if (!arc.is_on) line.expect("End");
    arc.schedule = scheduleNumber(line);
    return arc;
  }

  static int scheduleNumber(LineCursor& line) {
    line.expect("[");
    const int number = line.integer(1, kMostOutputs, "the number of a schedule");
    line.expect("]");
    return number;
  }

  /// `R[1]<>0,JMP LBL[1]`, and the label behind what is jumped over.
  void openCondition(LineCursor& line) {
    if (!list_.openDryCondition()) line.refuse("IF", "LBL before it");
    line.expect("R");
    line.expect("[");
    line.integer(1, kMostOutputs, "the number of a register");
    for (const char* text : {"]", "<>", "0", ",", "JMP", "LBL"}) line.expect(text);
    label_ = labelNumber(line);
  }

  void closeCondition(LineCursor& line) {
    const int label = labelNumber(line);
    if (label != label_ || !list_.closeDryCondition())
      line.refuse("LBL[" + std::to_string(label) + "]", kOneSwitch);
  }

  static int labelNumber(LineCursor& line) {
    line.expect("[");
    const int number = line.integer(1, kMostFanucPoints, "the number of a label");
    line.expect("]");
    return number;
  }

  /// Nothing of the tool's centre line.
  void readWeave(LineCursor& line) {
    if (line.take("End")) return;
    line.expect("Sine");
    if (!list_.weaveArc(scheduleNumber(line))) line.refuse("Weave", "Arc Start before it");
  }

  bool isContinued() const { return !text_.isAtEnd() && text_.lineAhead().take(":"); }

  void readStatement(LineCursor& line) {
    if (line.take("J"))
      list_.add(jointMove(line), line.line());
    else if (line.take("L"))
      list_.add(linearMove(line), line.line());
    else if (line.take("DO"))
      list_.add(output(line), line.line());
    else if (line.take("AO"))
      list_.add(level(line), line.line());
    else if (line.take("WAIT"))
      list_.add(wait(line), line.line());
    else if (line.take("CALL"))
      list_.add(FileCall{line.word("the name of a program")}, line.line());
    else if (isWord(line, "Arc"))
      list_.add(arc(line), line.line());
    else if (line.take("Weave"))
      readWeave(line);
    else if (line.take("IF"))
      openCondition(line);
    else if (line.take("LBL"))
      closeCondition(line);
    else if (line.take("UFRAME_NUM") || line.take("UTOOL_NUM"))
      readFrameNumber(line);
    else if (line.take("PAYLOAD"))
      readPayload(line);
    else
      line.refuse(
          "a statement that is known: J, L, DO, AO, Arc, Weave, WAIT, CALL, IF, LBL, UFRAME_NUM, UTOOL_NUM, "
          "PAYLOAD");
    if (line.isAtEnd() && isContinued()) return;
    endStatement(line);
  }

  static bool isWord(LineCursor line, const char* word) { return line.take(word); }

  static void readFrameNumber(LineCursor& line) {
    line.expect("=");
    line.integer(0, 99, "the number of a frame");
  }

  static void readPayload(LineCursor& line) {
    line.expect("[");
    line.integer(1, 99, "the number of a payload");
    line.expect("]");
  }

  RobotStatement jointMove(LineCursor& line) const {
    const FanucPoint& point = pointNamed(line);
    const auto* move = std::get_if<JointMove>(&point);
    if (move == nullptr) line.refuse("a point that states joints");
    percent(line);
    isRest(line);
    return *move;
  }

  RobotStatement linearMove(LineCursor& line) const {
    const FanucPoint& point = pointNamed(line);
    const auto* pose = std::get_if<TipMove>(&point);
    if (pose == nullptr) line.refuse("a point that states a pose");
    TipMove move = *pose;
    move.feed_mm_s = speed(line);
    move.rests = isRest(line);
    line.take("COORD");
    return move;
  }

  const FanucPoint& pointNamed(LineCursor& line) const {
    line.expect("P");
    line.expect("[");
    const int number = pointNumber(line);
    const auto found = points_.find(number);
    if (found == points_.end()) line.refuse("P[" + std::to_string(number) + "]", "a point below /POS");
    return found->second;
  }

  static void percent(LineCursor& line) {
    line.number(1.0, 100.0, "a speed in percent");
    line.expect("%");
  }

  double speed(LineCursor& line) const {
    if (line.take("WELD_SPEED")) {
      if (weld_mm_s_ == 0.0) line.refuse("WELD_SPEED", "the note '# weld_speed' before it");
      return weld_mm_s_;
    }
    const double value = line.number(1.0, kGreatestFanucSpeed, "a speed, 1 at least");
    const std::array<std::pair<const char*, double>, 3> units = {
        {{"mm/sec", 1.0}, {"cm/min", 10.0 / 60.0}, {"inch/min", 25.4 / 60.0}}};
    for (const auto& [name, mm_s] : units)
      if (line.take(name)) return value * mm_s;
    line.refuse("mm/sec, cm/min, inch/min or WELD_SPEED");
  }

  /// Whether the tip comes to the point.
  static bool isRest(LineCursor& line) {
    if (line.take("FINE")) return true;
    const std::string_view rest = line.rest();
    const std::size_t at = rest.find("CNT");
    if (at == std::string_view::npos || rest.find_first_not_of(' ') != at) line.refuse("FINE or CNT");
    line = LineCursor(rest.substr(at + 3), line.line(), line.file());
    line.integer(0, 100, "CNT0 to CNT100");
    return false;
  }

  static int outputNumber(LineCursor& line) {
    line.expect("[");
    const int number = line.integer(0, kMostOutputs, "the number of an output");
    line.expect("]");
    line.expect("=");
    return number;
  }

  static OutputSwitch output(LineCursor& line) {
    OutputSwitch output;
    output.output = outputNumber(line);
    output.is_on = line.take("ON");
    if (!output.is_on) line.expect("OFF");
    return output;
  }

  static LevelChange level(LineCursor& line) {
    LevelChange level;
    level.output = outputNumber(line);
    level.value = line.number(-kGreatestLevel, kGreatestLevel, "a value");
    return level;
  }

  static ProgramWait wait(LineCursor& line) {
    const ProgramWait wait{line.number(0.0, kLongestWait, "a wait in s")};
    line.expect("(");
    line.expect("sec");
    line.expect(")");
    return wait;
  }

  /// They stand last, and moves name them.
  void readPoints() {
    FanucText text = text_;
    for (bool is_found = false; !is_found;) {
      if (text.isAtEnd()) text_.end().refuse("/POS, which begins the points");
      LineCursor line = text.nextLine();
      is_found = line.take("/POS");
    }
    while (true) {
      LineCursor start = text.here();
      if (start.isAtEnd()) text_.end().refuse("/END");
      if (text.here().take("/END")) return text.here().expectEnd();
      auto [number, point] = fanucPoint(text);
      if (!points_.emplace(number, std::move(point)).second)
        start.refuse("P[" + std::to_string(number) + "]", "each point once");
    }
  }

  ReadFile file_;
  FanucText text_;
  StatementList list_;
  std::map<int, FanucPoint> points_;
  int label_ = 0;           ///< of the condition of a dry run before
  double weld_mm_s_ = 0.0;  ///< what WELD_SPEED is; 0 before it is stated
};

}  // namespace

std::vector<ReadStatement> parseFanuc(const RobotSourceText& source) { return FanucParser(source).parse(); }

}  // namespace lamina
