// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/reader/rapid_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "program/motion_values.hpp"
#include "program/rapid/rapid_words.hpp"
#include "program/rapid/reader/rapid_cursor.hpp"
#include "program/rapid/reader/rapid_motion.hpp"
#include "program/rapid/reader/rapid_source.hpp"
#include "program/rapid/writer/rapid_notes.hpp"

namespace lamina {
namespace {

/// So many motions lay this bead.
struct BeadRun {
  Bead bead;
  std::size_t motions = 0;
};

/// What the comments before a procedure report of a path, or of what is left of one.
struct PathNote {
  std::size_t line = 0;
  std::optional<ToolpathLayer> layer;  ///< that begins with the path; without paths
  bool is_resumed = false;             ///< goes on with the last path of the procedure before
  PathRole role = PathRole::Travel;
  bool is_closed = false;
  bool is_retracted = false;
  bool is_turned = false;
  std::size_t moves = 0;  ///< in this procedure
  std::vector<BeadRun> beads;
};

constexpr double kLargestNote = 1e6;  // mm

/// The words of one note.
class NoteWords {
 public:
  NoteWords(std::string_view text, std::size_t line, const std::string& file)
      : rest_(text), line_(line), file_(file) {}

  std::string_view next() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

  bool take(std::string_view word) {
    NoteWords ahead = *this;
    if (ahead.next() != word) return false;
    rest_ = ahead.rest_;
    return true;
  }

  template <class Number>
  Number number(const char* expected) {
    const std::string_view word = next();
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = result.ec == std::errc{} && result.ptr == word.data() + word.size();
    if (!is_number) refuse(word, expected);
    return value;
  }

  double length(const char* expected) {
    const double value = number<double>(expected);
    if (!(value >= 0.0 && value <= kLargestNote)) refuse(std::to_string(value), expected);
    return value;
  }

  void expectEnd() {
    const std::string_view word = next();
    if (!word.empty()) refuse(word, "nothing more in this note");
  }

  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
    throw InvalidProgram("'" + file_ + "' line " + std::to_string(line_) + ": found '" + std::string(found) +
                         "'; expected " + expected);
  }

 private:
  std::string_view rest_;
  std::size_t line_;
  const std::string& file_;
};

constexpr const char* kCount = "a number of moves, 1 at least";

PathRole roleOf(std::string_view name, const NoteWords& words) {
  try {
    return pathRoleFromString(std::string(name));
  } catch (const InvalidInput&) {
    words.refuse(name, "the role of a path");
  }
}

PathNote pathNote(NoteWords& words) {
  PathNote note;
  note.role = roleOf(words.next(), words);
  note.is_closed = words.take("closed");
  if (!note.is_closed && !words.take("open")) words.refuse(words.next(), "open or closed");
  note.is_retracted = words.take("retracted");
  note.is_turned = words.take("turned");
  note.moves = words.number<std::size_t>(kCount);
  return note;
}

ToolpathLayer layerNote(NoteWords& words) {
  ToolpathLayer layer;
  layer.z_mm = words.number<double>("the height of a layer");
  if (!(std::abs(layer.z_mm) <= kLargestNote))
    words.refuse(std::to_string(layer.z_mm), "the height of a layer");
  layer.height_mm = words.length("how high a layer is");
  return layer;
}

BeadRun beadNote(NoteWords& words) {
  BeadRun run;
  run.bead.width_mm = words.length("the width of a bead");
  run.bead.height_mm = words.length("the height of a bead");
  run.motions = words.number<std::size_t>("a number of motions");
  return run;
}

/// The text after the note's mark; nothing if it is no note.
std::optional<std::string_view> noteText(const RapidComment& comment) {
  const std::string_view mark = kRapidNote.substr(1);  // the comment is without its exclamation mark
  if (comment.text.substr(0, mark.size()) != mark) return std::nullopt;
  return comment.text.substr(mark.size());
}

/// Takes in one note of a path.
void readNote(NoteWords& words, std::size_t line, std::optional<ToolpathLayer>& layer,
              std::vector<PathNote>& notes) {
  const std::string_view kind = words.next();
  if (kind == "layer") {
    layer = layerNote(words);
  } else if (kind == "path" || kind == "resumed") {
    PathNote note;
    note.is_resumed = kind == "resumed";
    if (note.is_resumed)
      note.moves = words.number<std::size_t>(kCount);
    else
      note = pathNote(words);
    if (note.moves == 0) words.refuse("0", kCount);
    note.line = line;
    note.layer.swap(layer);
    notes.push_back(std::move(note));
  } else if (kind == "bead") {
    if (notes.empty() || notes.back().is_resumed) words.refuse(kind, "a note of a path before its beads");
    notes.back().beads.push_back(beadNote(words));
  } else {
    words.refuse(kind, "layer, path, resumed or bead");
  }
  words.expectEnd();
}

/// Reads the notes among the comments; others are left out.
/// @param file  for errors
/// @throws InvalidProgram naming file and line
std::vector<PathNote> readPathNotes(const std::vector<RapidComment>& comments, const std::string& file) {
  std::vector<PathNote> notes;
  std::optional<ToolpathLayer> layer;
  for (const RapidComment& comment : comments) {
    const auto text = noteText(comment);
    if (!text) continue;
    NoteWords words(*text, comment.line, file);
    readNote(words, comment.line, layer, notes);
  }
  return notes;
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

enum class ProcessState : std::uint8_t { Off, On };

/// Makes a toolpath of moves, in the order in which they are run, and of the notes that describe their paths.
class RapidAssembly {
 public:
  /// A procedure with moves begins.
  void begin(std::vector<PathNote> notes, const std::string& file);
  /// @param process  while it runs
  void add(const RapidMove& move, ProcessState process, std::size_t line);
  /// It ends.
  void end(std::size_t line);

  RapidRunning finish();

 private:
  [[noreturn]] void refuse(std::size_t line, const std::string& what) const;
  void openPath(std::size_t line);
  void addStart(const RapidMove& move, ProcessState process, std::size_t line);
  void addMotion(const RapidMove& move, ProcessState process, std::size_t line);
  void closePath();
  void addStations(std::size_t waypoints);
  std::vector<Bead> beads() const;

  std::vector<PathNote> notes_;
  std::string file_;
  std::size_t note_ = 0;   ///< the one whose moves come
  std::size_t moves_ = 0;  ///< of it, so far
  std::optional<RapidMove> last_;

  std::optional<PathNote> open_;  ///< the path that is being read
  std::string open_file_;
  std::vector<RapidMove> poses_;  ///< where it starts, and at the end of each motion
  RapidRunning running_;
};

constexpr double kSamePlace = 1e-3;  // mm: a few units of the last decimal

bool areSame(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs() == b.coeffs(); }

/// One orientation if it is that of all poses.
AlongPath<Eigen::Quaterniond> orientations(const std::vector<RapidMove>& poses, std::size_t count) {
  std::vector<Eigen::Quaterniond> each;
  each.reserve(count);
  bool is_common = true;
  for (std::size_t i = 0; i < count; ++i) {
    each.push_back(poses[i].target.orientation);
    is_common &= areSame(each[i], each[0]);
  }
  if (is_common) return each.front();
  return AlongPath<Eigen::Quaterniond>(std::move(each));
}

void RapidAssembly::refuse(std::size_t line, const std::string& what) const {
  throw InvalidProgram("'" + file_ + "' line " + std::to_string(line) + ": " + what);
}

void RapidAssembly::begin(std::vector<PathNote> notes, const std::string& file) {
  notes_ = std::move(notes);
  file_ = file;
  note_ = moves_ = 0;
}

void RapidAssembly::add(const RapidMove& move, ProcessState process, std::size_t line) {
  if (note_ == notes_.size())
    refuse(line, "a move of no path; expected a note '!# path' with it before the procedure");
  if (moves_ == 0 && !notes_[note_].is_resumed) openPath(line);
  if (!open_) refuse(line, "a path is resumed; expected one before it");
  if (poses_.empty())
    addStart(move, process, line);
  else
    addMotion(move, process, line);
  last_ = poses_.back();
  if (++moves_ == notes_[note_].moves) ++note_, moves_ = 0;
}

void RapidAssembly::openPath(std::size_t line) {
  closePath();
  open_ = notes_[note_];
  open_file_ = file_;
  poses_.clear();
  if (open_->is_turned) return;
  if (!last_) refuse(line, "the first move leads to the first path; expected a note with 'turned'");
  poses_.push_back(*last_);
}

void RapidAssembly::addStart(const RapidMove& move, ProcessState process, std::size_t line) {
  if (process == ProcessState::On) refuse(line, "the process is on while the tool takes its first pose");
  poses_.push_back(move);
  if (!last_) return;
  const double off_mm = (move.target.point - last_->target.point).norm();
  if (!(off_mm <= kSamePlace))
    refuse(line, "the tool moves by " + std::to_string(off_mm) + " mm where a path starts; expected a turn");
  poses_.back().target.point = last_->target.point;
}

void RapidAssembly::addMotion(const RapidMove& move, ProcessState process, std::size_t line) {
  const bool deposits = open_->role != PathRole::Travel;
  if (deposits != (process == ProcessState::On))
    refuse(line, std::string("the process is ") + (deposits ? "off" : "on") + " in a path that is " +
                     toString(open_->role) + "; expected it " + (deposits ? "on" : "off"));
  poses_.push_back(move);
}

void RapidAssembly::end(std::size_t line) {
  if (note_ != notes_.size())
    refuse(line, "the procedure ends amid the path of line " + std::to_string(notes_[note_].line) +
                     "; expected " + std::to_string(notes_[note_].moves) + " moves, found " +
                     std::to_string(moves_));
}

std::vector<Bead> RapidAssembly::beads() const {
  const std::size_t motions = poses_.size() - 1;
  if (open_->role == PathRole::Travel && open_->beads.empty()) return std::vector<Bead>(motions);
  std::vector<Bead> each;
  for (const BeadRun& run : open_->beads) {
    if (run.motions > motions - each.size()) break;
    each.insert(each.end(), run.motions, run.bead);
  }
  if (each.size() != motions)
    throw InvalidProgram("'" + open_file_ + "' line " + std::to_string(open_->line) +
                         ": the notes of beads do not fit the path's " + std::to_string(motions) +
                         " motions; expected one bead for each");
  return each;
}

void RapidAssembly::closePath() {
  if (!open_) return;
  const auto refuseOpen = [&](const std::string& what) {
    throw InvalidProgram("'" + open_file_ + "' line " + std::to_string(open_->line) + ": " + what);
  };
  if (poses_.size() < 2) refuseOpen("a path has no motion; expected one at least");
  if (open_->layer) {
    running_.toolpath.layers.push_back(*open_->layer);
  } else if (running_.toolpath.layers.empty()) {
    refuseOpen("a path before the first layer; expected a note '!# layer'");
  }
  Path path;
  path.role = open_->role;
  path.is_closed = open_->is_closed;
  path.process.is_retracted = open_->is_retracted;
  const PathEnds ends = path.is_closed ? PathEnds::Closed : PathEnds::Open;
  const bool returns = (poses_.back().target.point - poses_.front().target.point).norm() <= kSamePlace;
  if (path.is_closed && (poses_.size() < 3 || !returns))
    refuseOpen("a closed path does not return; expected it to end where it starts");
  path.bead = perWaypoint(beads(), ends);
  std::vector<double> feeds;
  for (std::size_t i = 1; i < poses_.size(); ++i) feeds.push_back(poses_[i].feed_mm_s);
  path.feed_mm_s = perWaypoint(feeds, ends);
  const std::size_t count = poses_.size() - (path.is_closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) path.points.push_back(poses_[i].target.point);
  path.orientation = orientations(poses_, count);
  // What follows starts where the path does, not at its return, which may differ in the last decimal.
  if (path.is_closed) last_->target.point = poses_.front().target.point;
  addStations(count);
  running_.toolpath.layers.back().paths.push_back(std::move(path));
  open_.reset();
}

void RapidAssembly::addStations(std::size_t waypoints) {
  const std::size_t layer = running_.toolpath.layers.size() - 1;
  const std::size_t path = running_.toolpath.layers.back().paths.size();
  for (std::size_t i = 0; i < poses_.size(); ++i)
    running_.stations.push_back({{layer, path, i % waypoints}, poses_[i]});
}

RapidRunning RapidAssembly::finish() {
  closePath();
  return std::move(running_);
}

bool moves(const RapidProcedure& procedure) {
  return std::any_of(
      procedure.statements.begin(), procedure.statements.end(), [](const RapidStatement& statement) {
        return statement.action == RapidAction::Move || statement.action == RapidAction::MoveJoints;
      });
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
    RapidRunning running = assembly_.finish();
    running.start = start_;
    return running;
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
        addMove(source_.moves[each.index], line);
      else
        applyProcess(procedure, each);
    }
    assembly_.end(line);
  }

  void addMove(RapidMove move, std::size_t line) {
    move.is_heeded = is_heeded_;
    assembly_.add(move, process_, line);
  }

  /// Nothing of the part: joints from which its first move sets out are kept.
  void callPassage(const RapidProcedure& procedure) {
    for (const RapidStatement& each : procedure.statements) {
      if (process_ == ProcessState::On) refuse(procedure, each.line, "the process is on; expected it off");
      if (each.action != RapidAction::MoveJoints && each.action != RapidAction::Move)
        refuse(procedure, each.line, "found another statement than a move; expected an approach or retract");
      if (each.action == RapidAction::MoveJoints && run_.empty()) start_ = source_.joint_moves[each.index];
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
  RapidAssembly assembly_;
  ProcessState process_ = ProcessState::Off;
  bool is_heeded_ = true;  ///< as a controller starts
  std::optional<RapidJoints> start_;
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
}

RapidRunning runningOf(const RapidSource& source, const std::string& part_name) {
  RapidRunning running = RapidRun(source).running();
  if (running.toolpath.layers.empty())
    throw InvalidProgram("'" + source.files.front() + "' has no motion; expected a program that deposits");
  running.toolpath.part_name = part_name;
  readFrame(source, running.toolpath);
  return running;
}

/// All modules of a program on disk; what was read of it refers to the texts.
class RapidFiles {
 public:
  explicit RapidFiles(const std::string& path) : file_(path) {
    texts_.push_back(readFile(path));
    addModule(file_.filename().string(), texts_.front(), source_);
    for (const std::string& module : readModuleNotes(source_.head, source_.files.front())) {
      const std::string name = module + ".mod";
      texts_.push_back(readFile((file_.parent_path() / name).string()));
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
  RapidSource source;
  for (const RapidText& module : modules) addModule(module.file, module.text, source);
  if (modules.empty()) throw InvalidProgram("there is no module; expected one at least");
  return runningOf(source, part_name).toolpath;
}

Toolpath readRapidFile(const std::string& path) { return RapidFiles(path).running().toolpath; }

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
