// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/inform/inform_parser.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "lamina/base/characters.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/program/robot/robot_angles.hpp"
#include "program/robot/notes/path_notes.hpp"
#include "program/robot/notes/robot_notes.hpp"
#include "program/robot/reader/line_sequence.hpp"

namespace lamina {
namespace {

constexpr int kMostInformPoints = 99999;
constexpr int kMostInformFrames = 99;
constexpr std::size_t kMostExternal = 6;
constexpr double kGreatestInformNumber = 4e9;  // pulses
constexpr double kGreatestInformSpeed = 1e6;   // in any unit

enum class InformPointKind : std::uint8_t { None, Pulses, Angles, Pose };

/// A point as it stands in the file.
struct InformPoint {
  InformPointKind kind = InformPointKind::None;
  std::array<double, 6> numbers{};
  std::size_t count = 6;  ///< of the numbers: as many as axes, where they are external
  bool is_used = false;
};

/// Of moves: V is in mm/s, or in cm/min as the note `speeds` says.
struct InformUnits {
  std::array<double, 6> pulses_per_deg = {0, 0, 0, 0, 0, 0};  ///< 0: not stated
  std::vector<double> external;                               ///< pulses in a mm or a degree
  double mm_s = 1.0;
};

class InformParser {
 public:
  explicit InformParser(const RobotSourceText& source)
      : file_{source.file, {}}, lines_(textLines(source.text), file_) {}

  std::vector<ReadStatement> parse() {
    readHead();
    readUnits();
    readPoints();
    readInstructions();
    return list_.take();
  }

 private:
  /// Notes on units hold for the whole file, also for points, which stand before them.
  void readUnits() {
    StatementList comments;
    for (LineSequence lines = lines_.fromStart(); !lines.isAtEnd();) {
      LineCursor line = lines.nextLine();
      if (line.take("'")) comments.addComment(line.rest(), line.line());
    }
    for (const ReadStatement& statement : comments.take()) {
      NoteWords words(std::get<NoteLine>(statement.what).text, statement.line, file_.name);
      if (words.take(kPulsesNote)) {
        for (double& pulses : units_.pulses_per_deg) pulses = pulsesIn(words, "pulses in a degree");
      } else if (words.take(kExternalPulsesNote)) {
        units_.external.clear();
        while (units_.external.size() < kMostExternal && !isAtEnd(words))
          units_.external.push_back(pulsesIn(words, "pulses in a mm or a degree"));
        words.expectEnd();
      } else if (words.take("speeds") && !words.take("mm/s")) {
        if (!words.take("cm/min")) words.refuse(words.next(), "mm/s or cm/min");
        units_.mm_s = 10.0 / 60.0;
      }
    }
  }

  static bool isAtEnd(NoteWords words) { return words.next().empty(); }

  static double pulsesIn(NoteWords& words, const char* expected) {
    const double pulses = words.number<double>(expected);
    if (!(std::abs(pulses) <= kGreatestInformNumber) || pulses == 0.0)
      words.refuse(numberText(pulses), expected);
    return pulses;
  }

  void readHead() {
    bool is_job = false;
    while (!lines_.isAtEnd()) {
      LineCursor line = lines_.nextLine();
      if (line.isAtEnd()) continue;
      if (!is_job) {
        line.expect("/JOB");
        file_.quotation.recognise();
        is_job = true;
      } else if (line.take("//POS")) {
        return line.expectEnd();
      } else if (!line.take("//NAME")) {
        line.refuse("//NAME or //POS");
      }
    }
    lines_.end().refuse(is_job ? "//POS" : "/JOB");
  }

  void readPoints() {
    InformPointKind kind = InformPointKind::None;
    std::optional<PointCounts> stated;
    while (!lines_.isAtEnd()) {
      LineCursor line = lines_.nextLine();
      if (line.isAtEnd()) continue;
      if (line.take("//INST")) {
        line.expectEnd();
        return requireCounts(line, stated);
      }
      if (line.take("///NPOS"))
        stated = pointCounts(line);
      else if (line.take("///"))
        kind = sectionOf(line, kind);
      else
        readPoint(line, kind);
    }
    lines_.end().refuse("//INST");
  }

  /// Of C, BC and EC.
  using PointCounts = std::array<int, 3>;

  static PointCounts pointCounts(LineCursor& line) {
    PointCounts counts{};
    counts[0] = line.integer(0, kMostInformPoints + 1, "the number of points");
    for (std::size_t i = 1; i < 6; ++i) {
      line.expect(",");
      const int count = line.integer(0, kMostInformPoints + 1, "a number of points");
      if (i < counts.size())
        counts[i] = count;
      else if (count != 0)
        line.refuse("no points of other kinds than C, BC and EC");
    }
    line.expectEnd();
    return counts;
  }

  void requireCounts(const LineCursor& line, const std::optional<PointCounts>& stated) const {
    if (!stated) return;
    PointCounts found{};
    for (const auto& [name, point] : points_) ++found[isBase(name) ? 1 : isStation(name) ? 2 : 0];
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] != (*stated)[i])
        line.refuse(std::to_string(found[i]) + " points", std::to_string((*stated)[i]) + ", as ///NPOS says");
  }

  static bool isBase(std::string_view name) { return upper(name.front()) == 'B'; }
  static bool isStation(std::string_view name) { return upper(name.front()) == 'E'; }

  static InformPointKind sectionOf(LineCursor& line, InformPointKind kind) {
    if (line.take("USER") || line.take("TOOL")) {
      line.integer(0, kMostInformFrames, "the number of a frame or tool");
    } else if (line.take("RCONF")) {
      do line.integer(0, 1, "0 or 1");
      while (line.take(","));
    } else if (line.take("POSTYPE")) {
      if (!line.take("PULSE") && !line.take("USER") && !line.take("ANGLE"))
        line.refuse("PULSE, USER or ANGLE");
      kind = InformPointKind::None;
    } else if (line.take("PULSE")) {
      kind = InformPointKind::Pulses;
    } else if (line.take("ANGLE")) {
      kind = InformPointKind::Angles;
    } else if (line.take("RECTAN")) {
      kind = InformPointKind::Pose;
    } else {
      line.refuse("NPOS, USER, TOOL, RCONF, POSTYPE, PULSE, ANGLE or RECTAN");
    }
    line.expectEnd();
    return kind;
  }

  void readPoint(LineCursor& line, InformPointKind kind) {
    if (kind == InformPointKind::None) line.refuse("///PULSE, ///ANGLE or ///RECTAN before a point");
    const std::string name = line.word("the name of a point");
    line.expect("=");
    InformPoint point;
    point.kind = kind;
    if (isBase(name) || isStation(name)) {
      readExternal(line, name, point);
    } else {
      for (std::size_t i = 0; i < 6; ++i) {
        if (i > 0) line.expect(",");
        const bool is_position = kind == InformPointKind::Pose && i < 3;
        const double limit = kind == InformPointKind::Pulses ? kGreatestInformNumber
                             : is_position                   ? kFarthestRead
                                                             : kGreatestAngle;
        point.numbers[i] = line.number(-limit, limit, "a number of a point");
      }
    }
    line.expectEnd();
    if (!points_.emplace(name, point).second) line.refuse(name, "each point once");
  }

  static void readExternal(LineCursor& line, const std::string& name, InformPoint& point) {
    if (point.kind != InformPointKind::Pulses) line.refuse(name, "///PULSE before a point of external axes");
    point.count = 0;
    do {
      if (point.count == point.numbers.size()) line.refuse("six external axes at most");
      point.numbers[point.count++] = line.number(-kGreatestInformNumber, kGreatestInformNumber, "pulses");
    } while (line.take(","));
  }

  void readInstructions() {
    bool is_begun = false;
    while (!lines_.isAtEnd()) {
      LineCursor line = lines_.nextLine();
      if (line.isAtEnd()) continue;
      if (!is_begun) {
        is_begun = line.take("NOP");
        if (!is_begun && !line.take("////") && !line.take("///")) line.refuse("/// or NOP");
        continue;
      }
      if (line.take("'")) {
        list_.addComment(line.rest(), line.line());
      } else if (line.take("END")) {
        if (list_.isConditionOpen()) line.refuse("END", "the label of the jump before it");
        line.expectEnd();
        return requireNothingMore();
      } else {
        readInstruction(line);
        line.expectEnd();
      }
    }
    lines_.end().refuse(is_begun ? "END" : "NOP");
  }

  void requireNothingMore() {
    while (!lines_.isAtEnd()) {
      LineCursor line = lines_.nextLine();
      if (!line.isAtEnd()) line.refuse("nothing after END");
    }
  }

  void readInstruction(LineCursor& line) {
    if (line.take("MOVJ"))
      list_.add(jointMove(line), line.line());
    else if (line.take("MOVL") || line.take("SMOVL"))
      list_.add(linearMove(line), line.line());
    else if (line.take("DOUT"))
      list_.add(output(line), line.line());
    else if (line.take("AOUT"))
      list_.add(level(line), line.line());
    else if (line.take("TIMER"))
      list_.add(timer(line), line.line());
    else if (line.take("ARCON"))
      list_.add(ArcSwitch{true, numberOf(line, "ASF", "the number of a schedule")}, line.line());
    else if (line.take("ARCOF"))
      list_.add(ArcSwitch{false, numberOf(line, "AEF", "the number of a schedule")}, line.line());
    else if (line.take("WVON"))
      readWeave(line);
    else if (line.take("WVOF"))
      return;
    else if (line.take("JUMP"))
      openCondition(line);
    else if (line.take("*"))
      closeCondition(line);
    else if (line.take("CALL"))
      list_.add(call(line), line.line());
    else
      line.refuse(
          "an instruction that is known: MOVJ, MOVL, SMOVL, DOUT, AOUT, ARCON, ARCOF, WVON, WVOF, TIMER, "
          "CALL, "
          "JUMP");
  }

  /// `*DRY1 IF B001<>0`, and the label behind what is jumped over.
  void openCondition(LineCursor& line) {
    if (!list_.openDryCondition()) line.refuse("JUMP", "the label of the jump before it");
    line.expect("*");
    label_ = line.word("a label");
    line.expect("IF");
    const std::string variable = line.word("a variable as B001");
    if (upper(variable.front()) != 'B') line.refuse(variable, "a variable as B001");
    line.expect("<>");
    line.expect("0");
  }

  void closeCondition(LineCursor& line) {
    const std::string label = line.word("a label");
    if (label != label_ || !list_.closeDryCondition()) line.refuse("*" + label, kOneSwitch);
  }

  void readWeave(LineCursor& line) {
    if (!list_.weaveArc(numberOf(line, "WEV", "the number of a schedule")))
      line.refuse("WVON", "ARCON before it");
  }

  const InformPoint& pointNamed(LineCursor& line) {
    const std::string name = line.word("the name of a point");
    if (isBase(name) || isStation(name)) line.refuse(name, "a point of the arm, as C00001");
    return usedPoint(line, name);
  }

  const InformPoint& usedPoint(const LineCursor& line, const std::string& name) {
    const auto found = points_.find(name);
    if (found == points_.end()) line.refuse(name, "a point below //POS");
    if (std::exchange(found->second.is_used, true)) line.refuse(name, "each point in one move");
    return found->second;
  }

  /// `BC00001` behind the arm's point, if it is there.
  void readBase(LineCursor& line, std::vector<double>& external) {
    LineCursor ahead = line;
    const std::string name = ahead.word("the name of a point, V or VJ");
    if (!isBase(name)) return;
    line = ahead;
    addExternal(line, name, external);
  }

  /// `+MOVJ EC00001 VJ=100.00` behind a move, if it is there.
  void readStation(LineCursor& line, std::vector<double>& external) {
    if (!line.take("+")) return;
    line.expect("MOVJ");
    const std::string name = line.word("the name of a point");
    if (!isStation(name)) line.refuse(name, "a point of a station, as EC00001");
    addExternal(line, name, external);
    if (!line.take("VJ")) return;
    line.expect("=");
    line.number(0.01, 100.0, "a speed in percent");
  }

  void addExternal(const LineCursor& line, const std::string& name, std::vector<double>& external) {
    const InformPoint& point = usedPoint(line, name);
    for (std::size_t i = 0; i < point.count; ++i) {
      if (external.size() == units_.external.size())
        line.refuse(name, "a note 'external_pulses' with the pulses of each external axis");
      external.push_back(point.numbers[i] / units_.external[external.size()]);
    }
  }

  JointMove jointMove(LineCursor& line) {
    const InformPoint& point = pointNamed(line);
    JointMove move;
    if (point.kind == InformPointKind::Pose) move.pose = poseOf(point);
    for (std::size_t j = 0; j < 6; ++j) {
      const double pulses = units_.pulses_per_deg[j];
      if (point.kind == InformPointKind::Pulses && pulses == 0.0)
        line.refuse("a note of the pulses in a degree, for a point in pulses");
      if (!move.pose)
        move.joints.arm_deg[j] =
            point.kind == InformPointKind::Pulses ? point.numbers[j] / pulses : point.numbers[j];
    }
    readBase(line, move.joints.external);
    line.expect("VJ");
    line.expect("=");
    line.number(0.01, 100.0, "a speed in percent");
    readStation(line, move.joints.external);
    return move;
  }

  static TipMove poseOf(const InformPoint& point) {
    TipMove move;
    move.point = Point3(point.numbers[0], point.numbers[1], point.numbers[2]);
    move.orientation = rotationOfAngles(RobotAngles{point.numbers[3], point.numbers[4], point.numbers[5]});
    return move;
  }

  TipMove linearMove(LineCursor& line) {
    const InformPoint& point = pointNamed(line);
    if (point.kind != InformPointKind::Pose) line.refuse("a point that states a pose");
    TipMove move = poseOf(point);
    readBase(line, move.external);
    line.expect("V");
    line.expect("=");
    move.feed_mm_s = units_.mm_s * line.number(0.1, kGreatestInformSpeed, "a speed, 0.1 at least");
    move.rests = true;
    if (line.take("PL")) {
      line.expect("=");
      move.rests = line.integer(0, 8, "PL=0 to PL=8") == 0;
    }
    readStation(line, move.external);
    return move;
  }

  static int outputNumber(LineCursor& line, const char* kind) {
    return numberOf(line, kind, "the number of an output");
  }

  static int numberOf(LineCursor& line, const char* kind, const char* expected) {
    line.expect(kind);
    line.expect("#(");
    const int number = line.integer(0, kMostOutputs, expected);
    line.expect(")");
    return number;
  }

  static OutputSwitch output(LineCursor& line) {
    OutputSwitch output;
    output.output = outputNumber(line, "OT");
    output.is_on = line.take("ON");
    if (!output.is_on) line.expect("OFF");
    return output;
  }

  static LevelChange level(LineCursor& line) {
    LevelChange level;
    level.output = outputNumber(line, "AO");
    level.value = line.number(-kGreatestLevel, kGreatestLevel, "a value in V");
    return level;
  }

  static ProgramWait timer(LineCursor& line) {
    line.expect("T");
    line.expect("=");
    return {line.number(0.0, kLongestWait, "a wait in s")};
  }

  static FileCall call(LineCursor& line) {
    line.expect("JOB");
    line.expect(":");
    return {line.word("the name of a job")};
  }

  ReadFile file_;
  LineSequence lines_;
  InformUnits units_;
  std::map<std::string, InformPoint> points_;
  StatementList list_;
  std::string label_;  ///< of the jump of a dry run before
};

}  // namespace

std::vector<ReadStatement> parseInform(const RobotSourceText& source) { return InformParser(source).parse(); }

}  // namespace lamina
