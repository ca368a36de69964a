// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/reader/rapid_reader.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "program/rapid/rapid_words.hpp"
#include "program/rapid/reader/rapid_cursor.hpp"
#include "program/rapid/reader/rapid_motion.hpp"
#include "program/rapid/reader/rapid_source.hpp"
#include "program/rapid/writer/rapid_notes.hpp"
#include "program/robot/notes/path_notes.hpp"
#include "program/robot/reader/path_assembly.hpp"

namespace lamina {
namespace {

constexpr double kLeastPerUnit = 1e-12;

/// The text after the note's mark; nothing if it is no note.
std::optional<std::string_view> noteText(const RapidComment& comment) {
  const std::string_view mark = kRapidNote.substr(1);  // the comment is without its exclamation mark
  if (comment.text.substr(0, mark.size()) != mark) return std::nullopt;
  return comment.text.substr(mark.size());
}

/// Reads the notes among the comments; others are left out.
/// @param file  for errors
/// @throws InvalidProgram naming file and line
std::vector<PathNote> readPathNotes(const std::vector<RapidComment>& comments, const std::string& file) {
  PathNotes notes;
  for (const RapidComment& comment : comments)
    if (const auto text = noteText(comment)) notes.read(NoteWords(*text, comment.line, file));
  return notes.take();
}

/// The names of the modules besides main, from the comments at its head.
std::vector<std::string> readModuleNotes(const std::vector<RapidComment>& comments, const std::string& file) {
  std::vector<std::string> names;
  for (const RapidComment& comment : comments) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, file);
    if (!words.take("module")) continue;
    names.emplace_back(words.next());
    try {
      requireRapidName("a module", names.back());
    } catch (const InvalidConfig&) {
      words.refuse(names.back(), "the name of a module");
    }
  }
  return names;
}

bool moves(const RapidProcedure& procedure) {
  return std::any_of(
      procedure.statements.begin(), procedure.statements.end(), [](const RapidStatement& statement) {
        return statement.action == RapidAction::Move || statement.action == RapidAction::MoveJoints;
      });
}

/// How long before the end of a run its wire stops [s], from the comments at its head.
void readWireStopNotes(RapidSource& source) {
  for (const RapidComment& comment : source.head) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, source.files.front());
    if (!words.take(kRapidWireStop)) continue;
    std::string trigger = "trigger of ";
    appendShortest(trigger, words.number<double>("how long before the end of a run the wire stops in s"));
    words.expectEnd();
    source.process.insert(trigger + " s");
  }
}

/// The levels of the first module, from the comments at its head.
void readLevelNotes(RapidSource& source) {
  source.levels.clear();
  for (const RapidComment& comment : source.head) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, source.files.front());
    if (!words.take(kRapidLevel)) continue;
    RapidLevel level;
    level.name = std::string(words.next());
    level.signal = lowerCase(words.next());
    level.per = words.number<double>("what the output is set to for each unit");
    if (level.name.empty() || level.signal.empty() || !(std::abs(level.per) >= kLeastPerUnit))
      words.refuse(level.name, "a process value, its output, and how much that is for each unit");
    words.expectEnd();
    std::string output = "analogue output " + level.signal + " of " + level.name + " by ";
    appendShortest(output, level.per);
    source.process.insert(output);
    source.levels.push_back(std::move(level));
  }
}

/// The external axes of the first module, from the comments at its head.
void readExternalNotes(RapidSource& source) {
  source.externals.clear();
  std::string all;
  for (const RapidComment& comment : source.head) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, source.files.front());
    if (!words.take(kRapidExternal)) continue;
    const std::string joint(words.next());
    const std::string axis(words.next());
    const auto sign = words.number<double>("1 or -1");
    const auto zero = words.number<double>("the value of the axis where its joint is at zero");
    words.expectEnd();
    std::string entry = joint + (sign < 0.0 ? "=-" : "=") + axis + (zero < 0.0 ? "" : "+");
    appendShortest(entry, zero);
    all += (all.empty() ? "" : ",") + entry;
    try {
      source.externals = rapidExternals(all);
    } catch (const InvalidConfig&) {
      words.refuse(axis, "a joint, and its axis, eax_a to eax_f, neither of which is named before");
    }
    if (std::abs(sign) != 1.0) words.refuse(axis, "1 or -1 behind it");
    source.process.insert("external axis " + entry);
  }
}

/// Whether a procedure leads to the part or away from it, which its comments say.
bool isPassage(const RapidProcedure& procedure) {
  return std::any_of(procedure.comments.begin(), procedure.comments.end(), [](const RapidComment& comment) {
    const auto text = noteText(comment);
    return text && (*text == kRapidApproach || *text == kRapidRetract);
  });
}

/// Runs main.
class RapidRun {
 public:
  explicit RapidRun(const RapidSource& source) : source_(source) {}

  RapidRunning running() {
    const auto main = source_.procedures.find("main");
    if (main == source_.procedures.end())
      throw InvalidProgram("'" + source_.files.front() + "' has no procedure main; expected one that is run");
    if (moves(main->second))
      refuse(main->second, main->second.statements.front().line,
             "main moves; expected the moves in procedures that it calls");
    for (const RapidStatement& statement : main->second.statements) {
      if (statement.action == RapidAction::Call) callFromMain(main->second, statement);
      if (statement.action == RapidAction::Heed) is_heeded_ = statement.index == 1;
    }
    return finished();
  }

 private:
  [[noreturn]] void refuse(const RapidProcedure& procedure, std::size_t line, const std::string& what) const {
    throw InvalidProgram("'" + source_.files[procedure.module] + "' line " + std::to_string(line) + ": " +
                         what);
  }

  const RapidProcedure& called(const RapidProcedure& caller, const RapidStatement& statement) const {
    const std::string& name = source_.called[statement.index];
    const auto found = source_.procedures.find(name);
    if (found == source_.procedures.end())
      refuse(caller, statement.line,
             "found '" + name + "'; expected an instruction that is known, or a procedure of the program");
    return found->second;
  }

  void callFromMain(const RapidProcedure& main, const RapidStatement& statement) {
    const RapidProcedure& procedure = called(main, statement);
    if (!moves(procedure)) return;
    if (isPassage(procedure)) return callPassage(procedure);
    if (std::find(run_.begin(), run_.end(), &procedure) != run_.end())
      refuse(main, statement.line, "a procedure that moves is called again; expected each once");
    run_.push_back(&procedure);
    const std::string& file = source_.files[procedure.module];
    assembly_.begin(readPathNotes(procedure.comments, file), file);
    std::size_t line = statement.line;
    for (const RapidStatement& each : procedure.statements) {
      line = each.line;
      if (each.action == RapidAction::MoveJoints)
        refuse(procedure, line, "found MoveAbsJ amid the part; expected it in the approach alone");
      if (each.action == RapidAction::Heed) is_heeded_ = each.index == 1;
      if (each.action == RapidAction::Move)
        addMove(procedure, source_.moves[each.index], line);
      else if (each.action == RapidAction::Level)
        changeLevel(procedure, source_.level_changes[each.index], line);
      else if (each.action == RapidAction::Wait)
        assembly_.addDwell(each.duration_s, line);
      else
        applyProcess(procedure, each);
    }
    assembly_.end(line);
  }

  void changeLevel(const RapidProcedure& procedure, const RapidLevelChange& change, std::size_t line) {
    const auto isItsOutput = [&](const RapidLevel& level) { return level.signal == change.signal; };
    if (std::none_of(source_.levels.begin(), source_.levels.end(), isItsOutput))
      refuse(procedure, line,
             "found analogue output '" + change.signal + "'; expected one that a note of a level names");
    if (change.trigger.empty())
      outputs_[change.signal] = change.value;
    else
      triggers_[change.trigger] = change;
  }

  void addMove(const RapidProcedure& procedure, RapidMove move, std::size_t line) {
    move.is_heeded = is_heeded_;
    move.module = procedure.module;
    const bool needs_arc = move.arc == RapidArc::On || move.arc == RapidArc::End;
    if (needs_arc && process_ == ProcessState::Off)
      refuse(procedure, line, "found a move of an arc that is not started; expected ArcLStart before it");
    for (const std::string& trigger : move.triggers)
      if (const auto found = triggers_.find(trigger); found != triggers_.end())
        outputs_[found->second.signal] = found->second.value;
    std::map<std::string, double> values;
    for (const RapidLevel& level : source_.levels)
      if (const auto found = outputs_.find(level.signal); found != outputs_.end())
        values[level.name] = found->second / level.per;
    assembly_.add(
        {move.target.point, move.target.orientation, move.feed_mm_s, std::move(values), moves_.size()},
        process_, line);
    if (move.arc == RapidArc::Start) process_ = ProcessState::On;
    if (move.arc == RapidArc::End) process_ = ProcessState::Off;
    moves_.push_back(std::move(move));
  }

  RapidRunning finished() {
    AssembledProgram assembled = assembly_.finish();
    RapidRunning running;
    running.toolpath = std::move(assembled.toolpath);
    for (const AssembledStation& station : assembled.stations) {
      running.stations.push_back({station.at, moves_[station.move.index], station.move.index});
      running.stations.back().move.target.point = station.move.point;
    }
    running.ways = std::move(ways_);
    return running;
  }

  /// Nothing of the part.
  void callPassage(const RapidProcedure& procedure) {
    for (const RapidStatement& each : procedure.statements) {
      if (process_ == ProcessState::On) refuse(procedure, each.line, "the process is on; expected it off");
      if (each.action != RapidAction::MoveJoints && each.action != RapidAction::Move)
        refuse(procedure, each.line, "found another statement than a move; expected an approach or retract");
      RapidWay way;
      way.before = moves_.size();
      way.line = each.line;
      if (each.action == RapidAction::MoveJoints) {
        way.joints = source_.joint_moves[each.index];
      } else {
        way.move = source_.moves[each.index];
        way.move.is_heeded = is_heeded_;
      }
      ways_.push_back(std::move(way));
    }
  }

  /// The process is on from the last output that is set to the first that is reset.
  void applyProcess(const RapidProcedure& procedure, const RapidStatement& statement) {
    if (statement.action == RapidAction::Set) process_ = ProcessState::On;
    if (statement.action == RapidAction::Reset) process_ = ProcessState::Off;
    if (statement.action != RapidAction::Call) return;
    const RapidProcedure& inner = called(procedure, statement);
    if (inner.statements.size() != 1 ||
        (inner.statements[0].action != RapidAction::Set && inner.statements[0].action != RapidAction::Reset))
      refuse(
          procedure, statement.line,
          "found a call of a procedure that does more than set or reset one output; expected such calls in "
          "main alone");
    applyProcess(inner, inner.statements[0]);
  }

  const RapidSource& source_;
  PathAssembly assembly_{{std::string(kRapidNote), "the procedure", "the procedure"}};
  std::vector<RapidMove> moves_;                      ///< in the order in which they are run
  std::map<std::string, double> outputs_;             ///< values of analogue outputs as they stand
  std::map<std::string, RapidLevelChange> triggers_;  ///< as they were last set up
  ProcessState process_ = ProcessState::Off;
  bool is_heeded_ = true;  ///< as a controller starts
  std::vector<RapidWay> ways_;
  std::vector<const RapidProcedure*> run_;
};

void readFrame(const RapidSource& source, Toolpath& toolpath) {
  StatedFrame stated;
  for (const RapidComment& comment : source.head) {
    try {
      readFrameComment(comment.text, stated);
    } catch (const InvalidProgram& error) {
      throw InvalidProgram("'" + source.files.front() + "' line " + std::to_string(comment.line) + ": " +
                           error.what());
    }
  }
  toolpath.part_from_layers = stated.bed_from_layers;
}

void addModule(const std::string& file, std::string_view text, RapidSource& source) {
  source.files.push_back(file);
  RapidCursor cursor(text, source.files.back());
  readRapidModule(cursor, source);
  readWireStopNotes(source);
  readLevelNotes(source);
  readExternalNotes(source);
}

RapidRunning runningOf(const RapidSource& source, const std::string& part_name) {
  RapidRunning running = RapidRun(source).running();
  if (running.toolpath.layers.empty())
    throw InvalidProgram("'" + source.files.front() + "' has no motion; expected a program that deposits");
  running.toolpath.part_name = part_name;
  readFrame(source, running.toolpath);
  return running;
}

StatedEquipment equipmentOf(const RapidSource& source, const RapidRunning& running) {
  StatedEquipment equipment;
  equipment.process = source.process;
  equipment.external = running.stations.front().move.target.external;
  for (const RapidStation& station : running.stations)
    equipment.moves_external |= station.move.target.external != equipment.external;
  const auto object = source.work_objects.find(source.work_object);
  if (object != source.work_objects.end()) equipment.bed_carrier = object->second.carrier;
  return equipment;
}

EquippedToolpath equippedRapid(const RapidSource& source, RapidRunning running) {
  StatedEquipment equipment = equipmentOf(source, running);
  return {std::move(running.toolpath), std::move(equipment)};
}

/// All modules of a program on disk; what was read of it refers to the texts.
class RapidFiles {
 public:
  explicit RapidFiles(const std::string& path) : file_(path) {
    texts_.push_back(readTextFile(path));
    addModule(file_.filename().string(), texts_.front(), source_);
    for (const std::string& module : readModuleNotes(source_.head, source_.files.front())) {
      const std::string name = module + ".mod";
      texts_.push_back(readTextFile(pathInAnyCase((file_.parent_path() / name).string())));
      addModule(name, texts_.back(), source_);
    }
  }

  const RapidSource& source() const { return source_; }
  RapidRunning running() const { return runningOf(source_, file_.stem().string()); }

 private:
  std::filesystem::path file_;
  std::deque<std::string> texts_;
  RapidSource source_;
};

}  // namespace

Toolpath readRapid(const std::vector<RapidText>& modules, const std::string& part_name) {
  return readEquippedRapid(modules, part_name).toolpath;
}

Toolpath readRapidFile(const std::string& path) { return RapidFiles(path).running().toolpath; }

EquippedToolpath readEquippedRapid(const std::vector<RapidText>& modules, const std::string& part_name) {
  RapidSource source;
  for (const RapidText& module : modules) addModule(module.file, module.text, source);
  if (modules.empty()) throw InvalidProgram("there is no module; expected one at least");
  return equippedRapid(source, runningOf(source, part_name));
}

EquippedToolpath readEquippedRapidFile(const std::string& path) {
  const RapidFiles files(path);
  return equippedRapid(files.source(), files.running());
}

StatedMotion readRapidMotion(const std::vector<RapidText>& modules, const std::string& part_name,
                             const KinematicModel& arm) {
  RapidSource source;
  for (const RapidText& module : modules) addModule(module.file, module.text, source);
  if (modules.empty()) throw InvalidProgram("there is no module; expected one at least");
  return rapidMotionOf(source, runningOf(source, part_name), arm);
}

StatedMotion readRapidMotionFile(const std::string& path, const KinematicModel& arm) {
  const RapidFiles files(path);
  return rapidMotionOf(files.source(), files.running(), arm);
}

}  // namespace lamina
