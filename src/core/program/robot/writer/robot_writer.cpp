// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_writer.hpp"

#include <map>
#include <memory>
#include <utility>

#include "lamina/base/error.hpp"
#include "program/robot/notes/robot_notes.hpp"
#include "program/robot/writer/controller_settings.hpp"
#include "program/robot/writer/robot_printer.hpp"
#include "program/robot/writer/robot_script.hpp"

namespace lamina {
namespace {

constexpr std::size_t kHeadLines = 60;       // of head, foot and the move to the start, of any language
constexpr double kShortestLongWait = 300.0;  // s: longer waits are several statements
constexpr std::size_t kMoveLines = 8;        // of a move and what stands round it
constexpr std::size_t kFilePoints = 2;       // that are not of a stretch: to the start, and the retract

/// What is in force where a file is cut.
class Standing {
 public:
  /// @param end_schedule  by which an arc ends
  explicit Standing(int end_schedule) : end_schedule_(end_schedule) {}

  void follow(const RobotStatement& statement) {
    if (const auto* output = std::get_if<OutputSwitch>(&statement)) on_[output->output] = output->is_on;
    if (const auto* arc = std::get_if<ArcSwitch>(&statement)) arc_ = *arc;
    if (const auto* level = std::get_if<LevelChange>(&statement)) levels_[level->output] = level->value;
  }

  std::vector<RobotStatement> stop() const {
    std::vector<RobotStatement> statements;
    for (const auto& [output, is_on] : on_)
      if (is_on) statements.emplace_back(OutputSwitch{output, false});
    if (arc_.is_on) statements.emplace_back(ArcSwitch{false, end_schedule_, arc_.weave});
    for (const auto& [output, value] : levels_) statements.emplace_back(LevelChange{output, 0.0, false});
    return statements;
  }

  std::vector<RobotStatement> goOn(double lead_s) const {
    std::vector<RobotStatement> statements;
    for (const auto& [output, value] : levels_) statements.emplace_back(LevelChange{output, value, false});
    for (const auto& [output, is_on] : on_)
      if (is_on) statements.emplace_back(OutputSwitch{output, true});
    if (arc_.is_on) statements.emplace_back(arc_);
    const bool starts = !statements.empty() && !std::holds_alternative<LevelChange>(statements.back());
    if (starts && lead_s > 0.0) statements.emplace_back(ProgramWait{lead_s});
    return statements;
  }

 private:
  int end_schedule_;
  ArcSwitch arc_;
  std::map<int, bool> on_;
  std::map<int, double> levels_;
};

/// A file is not cut behind it: the process would start again where the tip rests, and for no move.
std::size_t lastMoveOf(const std::vector<RobotStatement>& statements) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (std::holds_alternative<TipMove>(statements[i])) last = i;
  return last;
}

/// More than any language takes for a stretch.
RobotFileSize greatestSize(const std::vector<RobotStatement>& statements) {
  constexpr std::size_t kNoteWidth = 8;  // of the narrowest comments, at least
  RobotFileSize size;
  for (const RobotStatement& statement : statements) {
    const auto* note = std::get_if<NoteLine>(&statement);
    const auto* wait = std::get_if<ProgramWait>(&statement);
    size.lines += kMoveLines;
    if (note != nullptr) size.lines += note->text.size() / kNoteWidth;
    if (wait != nullptr) size.lines += static_cast<std::size_t>(wait->duration_s / kShortestLongWait);
    ++size.points;
  }
  return size;
}

/// Puts a program's statements into files.
class RobotFiles {
 public:
  RobotFiles(const RobotScript& script, const RobotDialect& dialect, const RobotSite& site)
      : script_(script), dialect_(dialect), site_(site) {}

  void write() {
    open();
    print(script_.approach());
    for (const RobotStretch& stretch : script_.stretches()) place(stretch);
    print(script_.retract());
  }

  std::vector<RobotFile> files(const std::string& name, const std::string& part_name) {
    std::vector<RobotFile> files;
    std::vector<std::string> names = {name};
    const bool has_main = printers_.size() > 1 && dialect_.has_calls;
    const std::size_t first = has_main ? 0 : 1;
    for (std::size_t i = first; i < printers_.size(); ++i)
      names.push_back(dialect_.name(name + "_" + std::to_string(i + 1), site_.settings));
    if (has_main) {
      auto main = dialect_.open(site_);
      for (std::size_t i = 1; i < names.size(); ++i) main->print(FileCall{names[i]});
      printers_.insert(printers_.begin(), std::move(main));
    } else {
      for (std::size_t i = 1; i < names.size(); ++i) printers_.front()->print(NoteLine{"file " + names[i]});
    }
    for (std::size_t i = 0; i < printers_.size(); ++i) {
      RobotFileHead head{names[i], {}, part_name};
      if (i == 0) head.notes = script_.headNotes();
      for (RobotFile& file : printers_[i]->files(head)) files.push_back(std::move(file));
    }
    return files;
  }

 private:
  RobotPrinter& last() { return *printers_.back(); }

  void open() { printers_.push_back(dialect_.open(site_)); }

  void print(const std::vector<RobotStatement>& statements) {
    for (const RobotStatement& statement : statements) print(statement);
  }

  void print(const RobotStatement& statement) {
    last().print(statement);
    if (const auto* move = std::get_if<TipMove>(&statement)) standing_ = move->posture;
  }

  /// By a move of the joints, where they are known. Files that are started one by one leave the arm off the
  /// part: it waits there, and somebody may have moved it since.
  void openAt(const std::optional<ArmPosture>& posture) {
    if (!dialect_.has_calls && standing_) print(script_.retractFrom(*standing_));
    open();
    if (!posture) return;
    if (dialect_.has_calls)
      print({NoteLine{std::string(kApproachNote)}, script_.jointMoveTo(*posture)});
    else
      print(script_.approachTo(*posture));
  }

  bool hasRoomFor(const RobotFileSize& size, std::size_t lines, std::size_t points) const {
    return size.lines + lines + kHeadLines <= dialect_.limits.lines &&
           size.points + points + kFilePoints <= dialect_.limits.points;
  }

  RobotFileSize sizeOf(const std::vector<RobotStatement>& statements) const {
    const auto trial = dialect_.open(site_);
    for (const RobotStatement& statement : statements) trial->print(statement);
    return trial->size();
  }

  /// Refuses with its place what the language cannot express.
  template <typename Writing>
  auto namingRun(const RobotStretch& stretch, const Writing& write) const {
    try {
      return write();
    } catch (const InvalidInput& error) {
      throw InvalidInput("the run from " + script_.place(stretch) + ": " + error.what());
    }
  }

  void place(const RobotStretch& stretch) {
    const std::vector<RobotStatement> statements = script_.statements(stretch);
    const RobotFileSize greatest = greatestSize(statements);
    if (hasRoomFor(last().size(), greatest.lines, greatest.points))
      return namingRun(stretch, [&] { print(statements); });
    const RobotFileSize needed = namingRun(stretch, [&] { return sizeOf(statements); });
    const bool is_new = stretch.begin == 0;
    if (!hasRoomFor(last().size(), needed.lines, needed.points)) {
      if (!is_new) openAt(script_.postureAtStart(stretch));
      if (!hasRoomFor(last().size(), needed.lines, needed.points)) return cut(stretch, statements, needed);
    }
    print(statements);
  }

  void cut(const RobotStretch& stretch, const std::vector<RobotStatement>& statements,
           const RobotFileSize& needed) {
    if (!site_.settings.may_cut)
      throw InvalidConfig("the run from " + script_.place(stretch) + " takes " +
                          std::to_string(needed.lines) + " lines and " + std::to_string(needed.points) +
                          " points of " + toString(dialect_.language) + ", more than a file may have (" +
                          dialect_.limit_key +
                          "); expected robot_program.allow_cut, which stops the process amid the run");
    Standing standing(site_.settings.arc.end_schedule);
    const std::size_t last_move = lastMoveOf(statements);
    for (std::size_t i = 0; i < statements.size(); ++i) {
      standing.follow(statements[i]);
      const auto* move = std::get_if<TipMove>(&statements[i]);
      const bool is_full = !hasRoomFor(last().size(), kMoveLines, 1);
      if (move == nullptr || !is_full || i == last_move) {
        print(statements[i]);
        continue;
      }
      TipMove end = *move;
      end.rests = true;
      print(RobotStatement(end));
      print(standing.stop());
      openAt(move->posture);
      if (move->moves_left > 1)
        print(RobotStatement(NoteLine{"resumed " + std::to_string(move->moves_left - 1)}));
      print(standing.goOn(site_.settings.process_lead_s));
    }
  }

  const RobotScript& script_;
  const RobotDialect& dialect_;
  const RobotSite& site_;
  std::vector<std::unique_ptr<RobotPrinter>> printers_;
  std::optional<ArmPosture> standing_;  ///< of the last move of the tip; nothing without an arm
};

void requireMemory(const std::vector<RobotFile>& files, const RobotDialect& dialect) {
  std::size_t bytes = 0;
  for (const RobotFile& file : files) bytes += file.text.size();
  if (bytes > dialect.limits.bytes_in_all)
    throw InvalidConfig("the program takes " + std::to_string(bytes) + " bytes in " +
                        std::to_string(files.size()) + " files; expected " +
                        std::to_string(dialect.limits.bytes_in_all) + " at most (" + dialect.limit_key +
                        "), or fewer points");
}

/// Rails are of the arm's group, rotary axes of one behind it.
void requireRailsFirst(const std::vector<JointKind>& kinds, RobotLanguage language) {
  for (std::size_t k = 1; k < kinds.size(); ++k)
    if (kinds[k] == JointKind::Linear && kinds[k - 1] == JointKind::Rotary)
      throw InvalidConfig("external axis " + std::to_string(k + 1) +
                          " of the controller is a rail, and axis " + std::to_string(k) +
                          " turns; expected rails first in " + toString(language) +
                          " (robot_program.external_axes)");
}

void requireExternals(const ControllerMap& map, RobotLanguage language, const KinematicModel& arm) {
  const std::string mismatch = externalMismatch(map, arm);
  if (!mismatch.empty()) throw InvalidConfig("robot_program.external_axes: its axes " + mismatch);
  if (language == RobotLanguage::Fanuc || language == RobotLanguage::Inform)
    requireRailsFirst(controllerAxisKinds(map, arm), language);
}

}  // namespace

void requireWritable(const RobotProgramRequest& request, const KinematicModel& arm) {
  const RobotProgramSettings settings = withArmController(request.settings, request.language, arm);
  const ControllerMap map = controllerMap(request.language, settings);
  requireExternals(map, request.language, arm);
  const RobotSite site{settings, std::nullopt, map, controllerAxisKinds(map, arm)};
  const RobotDialect dialect = robotDialect(request.language, settings);
  dialect.name(settings.name.empty() ? request.name : settings.name, settings);
  dialect.open(site);
}

std::vector<RobotFile> robotProgram(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                                    const RobotProgramRequest& request, const RobotMotion* robot) {
  const RobotProgramSettings settings =
      robot == nullptr ? request.settings : withArmController(request.settings, request.language, robot->arm);
  const RobotDialect dialect = robotDialect(request.language, settings);
  const std::string name = dialect.name(settings.name.empty() ? request.name : settings.name, settings);
  RobotSite site{settings, std::nullopt, controllerMap(request.language, settings), {}};
  if (robot != nullptr)
    requireExternals(site.map, request.language, robot->arm);
  else if (!site.map.external.empty())
    throw InvalidConfig("robot_program.external_axes is '" + settings.external_axes +
                        "' without an arm that has joints for them; expected none");
  const RobotScript script({toolpath, bed_from_part, robot}, settings, site.map);
  site.settings = script.settings();
  site.cell = script.cell();
  site.external = script.externalKinds();
  RobotFiles writing(script, dialect, site);
  writing.write();
  std::vector<RobotFile> files = writing.files(name, toolpath.part_name);
  requireMemory(files, dialect);
  return files;
}

}  // namespace lamina
