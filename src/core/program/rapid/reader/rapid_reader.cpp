// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/rapid/reader/rapid_reader.hpp"

#include <algorithm>
#include <deque>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/program_frame.hpp"
#include "program/rapid/reader/rapid_assembly.hpp"
#include "program/rapid/reader/rapid_path_notes.hpp"
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {
namespace {

bool moves(const RapidProcedure& procedure) {
  return std::any_of(procedure.statements.begin(), procedure.statements.end(),
                     [](const RapidStatement& statement) { return statement.action == RapidAction::Move; });
}

/// Runs main.
class RapidRun {
 public:
  explicit RapidRun(const RapidSource& source) : source_(source) {}

  Toolpath toolpath() {
    const auto main = source_.procedures.find("main");
    if (main == source_.procedures.end())
      throw InvalidProgram("'" + source_.files.front() + "' has no procedure main; expected one that is run");
    if (moves(main->second))
      refuse(main->second, main->second.statements.front().line,
             "main moves; expected the moves in procedures that it calls");
    for (const RapidStatement& statement : main->second.statements)
      if (statement.action == RapidAction::Call) callFromMain(main->second, statement);
    return assembly_.finish();
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
    if (std::find(run_.begin(), run_.end(), &procedure) != run_.end())
      refuse(main, statement.line, "a procedure that moves is called again; expected each once");
    run_.push_back(&procedure);
    const std::string& file = source_.files[procedure.module];
    assembly_.begin(readPathNotes(procedure.comments, file), file);
    std::size_t line = statement.line;
    for (const RapidStatement& each : procedure.statements) {
      line = each.line;
      if (each.action == RapidAction::Move)
        assembly_.add(source_.moves[each.index], process_, line);
      else
        applyProcess(procedure, each);
    }
    assembly_.end(line);
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
  std::vector<const RapidProcedure*> run_;
};

void readFrame(const RapidSource& source, Toolpath& toolpath) {
  StatedFrame told;
  for (const RapidComment& comment : source.head) {
    try {
      readFrameComment(comment.text, told);
    } catch (const InvalidProgram& error) {
      throw InvalidProgram("'" + source.files.front() + "' line " + std::to_string(comment.line) + ": " +
                           error.what());
    }
  }
  toolpath.part_from_layers = told.bed_from_layers;
}

void addModule(const std::string& file, std::string_view text, RapidSource& source) {
  source.files.push_back(file);
  RapidCursor cursor(text, source.files.back());
  readRapidModule(cursor, source);
}

Toolpath toolpathOf(const RapidSource& source, const std::string& part_name) {
  Toolpath toolpath = RapidRun(source).toolpath();
  if (toolpath.layers.empty())
    throw InvalidProgram("'" + source.files.front() + "' has no motion; expected a program that deposits");
  toolpath.part_name = part_name;
  readFrame(source, toolpath);
  return toolpath;
}

}  // namespace

Toolpath readRapid(const std::vector<RapidText>& modules, const std::string& part_name) {
  RapidSource source;
  for (const RapidText& module : modules) addModule(module.file, module.text, source);
  if (modules.empty()) throw InvalidProgram("there is no module; expected one at least");
  return toolpathOf(source, part_name);
}

Toolpath readRapidFile(const std::string& path) {
  const std::filesystem::path file(path);
  std::deque<std::string> texts = {readFile(path)};  // comments are views into them
  RapidSource source;
  addModule(file.filename().string(), texts.front(), source);
  for (const std::string& module : readModuleNotes(source.head, source.files.front())) {
    const std::string name = module + ".mod";
    texts.push_back(readFile((file.parent_path() / name).string()));
    addModule(name, texts.back(), source);
  }
  return toolpathOf(source, file.stem().string());
}

}  // namespace lamina
