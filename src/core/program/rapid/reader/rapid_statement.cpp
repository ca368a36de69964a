// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include "base/decimals.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "program/rapid/rapid_words.hpp"
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {
namespace {

constexpr double kLongestRapidWait = 1e6;  // s

double knownNumber(RapidCursor& cursor, const RapidSource& source) {
  const std::size_t line = cursor.line();
  const std::string name = cursor.takeName("a number or its name");
  const auto found = source.numbers.find(name);
  if (found == source.numbers.end())
    cursor.refuseAt(line, "found '" + name + "'; expected a number, or a num that is declared");
  return found->second;
}

bool startsNumber(const RapidCursor& cursor) {
  for (const char c : std::string_view("0123456789."))
    if (cursor.isNext(c)) return true;
  return false;
}

double takeTerm(RapidCursor& cursor, const RapidSource& source) {
  return startsNumber(cursor) ? cursor.takeNumber("a number") : knownNumber(cursor, source);
}

/// Numbers and their names, with + and - between them and before the first.
double takeSum(RapidCursor& cursor, const RapidSource& source) {
  double sign = cursor.take("-") ? -1.0 : 1.0;
  if (sign > 0.0) cursor.take("+");
  double sum = sign * takeTerm(cursor, source);
  while (cursor.isNext('+') || cursor.isNext('-')) {
    sign = cursor.take("-") ? -1.0 : 1.0;
    if (sign > 0.0) cursor.expect("+");
    sum += sign * takeTerm(cursor, source);
  }
  return sum;
}

RapidTarget takeOffset(RapidCursor& cursor, const RapidSource& source) {
  cursor.expect("(");
  const std::size_t line = cursor.line();
  const std::string name = cursor.takeName("the target that the offsets are from");
  const auto found = source.targets.find(name);
  if (found == source.targets.end())
    cursor.refuseAt(line, "found '" + name + "'; expected a robtarget that is declared");
  RapidTarget target = found->second;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    cursor.expect(",");
    target.point[axis] += takeSum(cursor, source);
  }
  cursor.expect(")");
  return target;
}

double takeSpeed(RapidCursor& cursor, const RapidSource& source) {
  const std::size_t line = cursor.line();
  const std::string name = cursor.takeName("the name of a speed");
  if (const auto found = source.speeds.find(name); found != source.speeds.end()) return found->second;
  const std::optional<double> own = rapidSpeed(name);
  if (!own)
    cursor.refuseAt(line, "found speed '" + name + "'; expected one that is declared, or RAPID's own");
  return *own;
}

void takeZone(RapidCursor& cursor, const RapidSource& source) {
  const std::size_t line = cursor.line();
  const std::string name = cursor.takeName("the name of a zone");
  if (!isRapidZone(name) && source.names.count(name) == 0)
    cursor.refuseAt(line, "found zone '" + name + "'; expected one that is declared, or RAPID's own");
}

/// What ends a move: `TOOL\WObj:=WORK OBJECT`, the same in all of them.
void takeToolAndObject(RapidCursor& cursor, RapidSource& source) {
  std::size_t line = cursor.line();
  const std::string tool = cursor.takeName("the name of a tool");
  if (source.tool.empty()) source.tool = tool;
  if (tool != source.tool)
    cursor.refuseAt(line, "found tool '" + tool + "'; expected '" + source.tool + "' as in the moves before");
  cursor.expect("\\");
  cursor.expectWord("wobj");
  cursor.expect(":=");
  line = cursor.line();
  const std::string work_object = cursor.takeName("the name of a work object");
  if (source.work_object.empty()) source.work_object = work_object;
  if (work_object != source.work_object)
    cursor.refuseAt(line, "found work object '" + work_object + "'; expected '" + source.work_object +
                              "' as in the moves before");
}

std::optional<RapidArc> arcOf(const std::string& word) {
  if (word == "movel" || word == "triggl") return RapidArc::None;
  if (word == "arclstart") return RapidArc::Start;
  if (word == "arcl") return RapidArc::On;
  if (word == "arclend") return RapidArc::End;
  return std::nullopt;
}

/// `seam1,weld1\Weave:=weave1,`: data that the controller holds.
void takeArcData(RapidCursor& cursor, RapidSource& source) {
  source.process.insert("seam data " + cursor.takeName("the name of seam data"));
  cursor.expect(",");
  source.process.insert("weld data " + cursor.takeName("the name of weld data"));
  if (cursor.take("\\")) {
    cursor.expectWord("weave");
    cursor.expect(":=");
    source.process.insert("weave data " + cursor.takeName("the name of weave data"));
  }
  cursor.expect(",");
}

void addTimed(const std::string& word, double duration_s, RapidSource& source) {
  std::string text = word + " of ";
  appendShortest(text, duration_s);
  source.process.insert(text + " s");
}

/// `lamina_level_1\T2:=lamina_level_2`.
std::vector<std::string> takeTriggers(RapidCursor& cursor) {
  std::vector<std::string> triggers = {cursor.takeName("the name of a trigger")};
  for (int number = 2; cursor.take("\\"); ++number) {
    cursor.expectWord("t" + std::to_string(number));
    cursor.expect(":=");
    triggers.push_back(cursor.takeName("the name of a trigger"));
  }
  return triggers;
}

/// After its first word.
RapidMove takeMove(RapidCursor& cursor, RapidSource& source, const std::string& word) {
  RapidMove move;
  move.line = cursor.line();
  move.target = cursor.takeWord("offs") ? takeOffset(cursor, source) : readRapidTarget(cursor);
  cursor.expect(",");
  move.feed_mm_s = takeSpeed(cursor, source);
  cursor.expect(",");
  if (word == "triggl") {
    move.triggers = takeTriggers(cursor);
    cursor.expect(",");
  }
  move.arc = *arcOf(word);
  if (move.arc != RapidArc::None) takeArcData(cursor, source);
  takeZone(cursor, source);
  cursor.expect(",");
  takeToolAndObject(cursor, source);
  return move;
}

/// After its first word.
RapidJoints takeJointMove(RapidCursor& cursor, RapidSource& source) {
  RapidJoints joints = readRapidJoints(cursor);
  if (cursor.take("\\")) cursor.expectWord("noeoffs");
  cursor.expect(",");
  takeSpeed(cursor, source);
  cursor.expect(",");
  takeZone(cursor, source);
  cursor.expect(",");
  takeToolAndObject(cursor, source);
  return joints;
}

double takeSigned(RapidCursor& cursor, const char* expected) {
  const double sign = cursor.take("-") ? -1.0 : 1.0;
  return sign * cursor.takeNumber(expected);
}

void addLevelChange(RapidCursor& cursor, RapidSource& source, RapidStatement& statement,
                    std::string trigger) {
  RapidLevelChange change;
  change.signal = cursor.takeName("the name of an analogue output");
  cursor.expect(",");
  change.value = takeSigned(cursor, "a value of the output");
  change.trigger = std::move(trigger);
  statement.action = RapidAction::Level;
  statement.index = source.level_changes.size();
  source.level_changes.push_back(std::move(change));
}

/// Behind `\Start`: `\AOp:=aoLaser,0.3`.
void takeLevelTrigger(RapidCursor& cursor, RapidSource& source, RapidStatement& statement,
                      const std::string& trigger) {
  cursor.expect("\\");
  cursor.expectWord("aop");
  cursor.expect(":=");
  addLevelChange(cursor, source, statement, trigger);
}

/// What prepares a program: signals, files, triggers. After its first word.
bool takePreparation(RapidCursor& cursor, RapidSource& source, RapidStatement& statement,
                     const std::string& word) {
  if (word == "aliasio") {
    const std::string on_controller =
        cursor.takeString("the signal's name on the controller in quotation marks");
    cursor.expect(",");
    source.process.insert(cursor.takeName("the name of a signal") + " as " + on_controller);
  } else if (word == "singarea") {
    cursor.expect("\\");
    if (!cursor.takeWord("wrist") && !cursor.takeWord("off")) cursor.refuse("Wrist or Off");
  } else if (word == "actunit") {
    cursor.takeName("the name of a mechanical unit");
  } else if (word == "waittime") {
    addTimed("wait", takeSum(cursor, source), source);
  } else if (word == "setao") {
    addLevelChange(cursor, source, statement, "");
  } else if (word == "waitdi") {
    cursor.takeName("the name of a signal");
    cursor.expect(",");
    cursor.expectWord("high");
  } else if (word == "triggio") {
    const std::string trigger = cursor.takeName("the name of a trigger");
    cursor.expect(",");
    const double lead = takeSum(cursor, source);
    cursor.expect("\\");
    if (cursor.takeWord("start")) return takeLevelTrigger(cursor, source, statement, trigger), true;
    if (cursor.takeWord("time")) {
      addTimed("trigger", lead, source);
      cursor.expect("\\");
    }
    cursor.expectWord("dop");
    cursor.expect(":=");
    cursor.takeName("the name of a signal");
    cursor.expect(",");
    cursor.takeNumber("a value of the signal");
  } else if (word == "load" || word == "unload") {
    if (word == "load") {
      cursor.expect("\\");
      cursor.expectWord("dynamic");
      cursor.expect(",");
    }
    cursor.expectWord("diskhome");
    cursor.expect("\\");
    cursor.expectWord("file");
    cursor.expect(":=");
    cursor.takeString("the name of a file in quotation marks");
  } else {
    return false;
  }
  return true;
}

/// A call by a name in quotation marks.
void takeLateCall(RapidCursor& cursor, RapidSource& source, RapidStatement& statement) {
  statement.action = RapidAction::Call;
  statement.index = source.called.size();
  source.called.push_back(lowerCase(cursor.takeString("a procedure's name in quotation marks")));
  cursor.expect("%");
}

/// `VelSet 20,5000;`: the speed of a dry run, or the end of that.
void takeDrySpeed(RapidCursor& cursor, RapidSource& source) {
  cursor.expectWord("velset");
  const double percent = cursor.takeNumber("a speed in percent");
  if (!(percent > 0.0 && percent <= 100.0)) cursor.refuse("a speed above 0 and up to 100 percent");
  cursor.expect(",");
  cursor.takeNumber("a speed in mm/s");
  cursor.expect(";");
  if (percent < 100.0) source.process.insert("dry run at " + numberText(percent) + " % of the speed");
}

/// Behind IF, `NOT lamina_dry`: with THEN it holds up to ENDIF, otherwise for one statement; or `lamina_dry`
/// with the speed of a dry run.
/// @return whether no statement is left to which it applies alone
bool takeDryCondition(RapidCursor& cursor, RapidSource& source) {
  const bool is_of_process = cursor.takeWord("not");
  cursor.expectWord(kRapidDryFlag);
  if (source.names.count(std::string(kRapidDryFlag)) == 0)
    cursor.refuse("lamina_dry declared as a bool, before a condition of it");
  if (is_of_process)
    source.is_conditional = cursor.takeWord("then");
  else
    takeDrySpeed(cursor, source);
  return source.is_conditional || !is_of_process;
}

bool switchesProcess(const RapidStatement& statement) {
  return statement.action == RapidAction::Set || statement.action == RapidAction::Level ||
         statement.action == RapidAction::Preparing;
}

/// A dry run keeps the triggers that moves name, and nothing else instead of the process.
void requireOfDryRun(const RapidCursor& cursor, const RapidSource& source, const RapidStatement& statement) {
  if (statement.action == RapidAction::Level) {
    const RapidLevelChange& change = source.level_changes[statement.index];
    if (!change.trigger.empty() && change.value == 0.0) return;
  }
  cursor.refuseAt(statement.line,
                  "found a statement that a dry run runs instead of the process; expected TriggIO that sets "
                  "an analogue output to 0");
}

void requireOfProcess(const RapidCursor& cursor, const RapidStatement& statement) {
  if (switchesProcess(statement)) return;
  cursor.refuseAt(
      statement.line,
      "found a statement that does not start the process under the condition of a dry run; expected "
      "Set, SetAO, TriggIO, WaitDI or WaitTime");
}

/// Where a condition goes on with what a dry run does instead, or ends.
bool takeEndOfCondition(RapidCursor& cursor, RapidSource& source) {
  if (!source.is_conditional) return false;
  if (!source.is_dry && cursor.takeWord("else")) return source.is_dry = true;
  if (!cursor.takeWord("endif")) return false;
  source.is_conditional = source.is_dry = false;
  return true;
}

/// Waits for the tool to stand are the toolpath's.
void takeWait(RapidCursor& cursor, RapidStatement& statement) {
  statement.action = RapidAction::Wait;
  statement.duration_s = cursor.takeNumber("a wait in s");
  if (!(statement.duration_s >= 0.0 && statement.duration_s <= kLongestRapidWait))
    cursor.refuseAt(statement.line, "a wait is " + numberText(statement.duration_s) + " s; expected 0 to " +
                                        numberText(kLongestRapidWait) + " s");
}

}  // namespace

void readRapidStatement(RapidCursor& cursor, RapidSource& source, RapidProcedure& procedure) {
  if (takeEndOfCondition(cursor, source)) return;
  const bool is_condition = !source.is_conditional && cursor.takeWord("if");
  if (is_condition && takeDryCondition(cursor, source)) return;
  RapidStatement statement;
  statement.line = cursor.line();
  if (cursor.take("%")) {
    takeLateCall(cursor, source, statement);
  } else {
    std::string word = cursor.takeName("an instruction");
    if (word == "waittime" && cursor.take("\\")) {
      cursor.expectWord("inpos");
      cursor.expect(",");
      takeWait(cursor, statement);
    } else if (arcOf(word)) {
      statement.action = RapidAction::Move;
      statement.index = source.moves.size();
      source.moves.push_back(takeMove(cursor, source, word));
    } else if (word == "moveabsj") {
      statement.action = RapidAction::MoveJoints;
      statement.index = source.joint_moves.size();
      source.joint_moves.push_back(takeJointMove(cursor, source));
    } else if (word == "confl") {
      statement.action = RapidAction::Heed;
      cursor.expect("\\");
      statement.index = cursor.takeWord("on") ? 1 : 0;
      if (statement.index == 0 && !cursor.takeWord("off")) cursor.refuse("On or Off");
    } else if (word == "set" || word == "reset") {
      statement.action = word == "set" ? RapidAction::Set : RapidAction::Reset;
      source.process.insert(word + " " + cursor.takeName("the name of a signal"));
    } else if (!takePreparation(cursor, source, statement, word)) {
      if (!cursor.isNext(';'))
        cursor.refuseAt(
            statement.line,
            "found instruction '" + word +
                "'; expected MoveL, TriggL, ArcLStart, ArcL, ArcLEnd, MoveAbsJ, Set, Reset, SetAO, "
                "WaitTime, "
                "WaitDI, AliasIO, ConfL, SingArea, ActUnit, TriggIO, Load, UnLoad or a call");
      statement.action = RapidAction::Call;
      statement.index = source.called.size();
      source.called.push_back(std::move(word));
    }
  }
  cursor.expect(";");
  if (source.is_dry) return requireOfDryRun(cursor, source, statement);
  if (is_condition || source.is_conditional) requireOfProcess(cursor, statement);
  if (statement.action != RapidAction::Preparing) procedure.statements.push_back(statement);
}

}  // namespace lamina
