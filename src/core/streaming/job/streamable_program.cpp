// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/streamable_program.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "program/gcode/slicer_comments.hpp"

namespace lamina {
namespace {

/// Commands whose argument is text, in which parentheses are no comment.
bool carriesText(std::string_view command) {
  constexpr std::array<std::string_view, 4> kCommands = {"M117", "M118", "M23 ", "M32 "};
  return std::any_of(kCommands.begin(), kCommands.end(),
                     [&](std::string_view name) { return command.substr(0, name.size()) == name; });
}

std::string withoutParentheses(std::string_view command) {
  std::string kept;
  int depth = 0;
  for (const char c : command) {
    if (c == '(') ++depth;
    if (depth == 0) kept += c;
    if (c == ')' && depth > 0) --depth;
  }
  return std::string(trimmed(kept));
}

bool isCommand(std::string_view line, std::string_view command) {
  return line.substr(0, command.size()) == command &&
         (line.size() == command.size() ||
          std::isdigit(static_cast<unsigned char>(line[command.size()])) == 0);
}

bool isPrintableAscii(char c) { return c >= ' ' && c <= '~'; }

/// What is wrong with a command; empty if nothing is.
std::string defectOf(const std::string& command, int max_line_bytes) {
  // The longest number a line can get is counted, so that a line passes wherever it stands.
  constexpr std::size_t kFrameBytes = std::string_view("N4294967295 *255\n").size();
  const std::size_t framed = command.size() + kFrameBytes;
  if (framed > static_cast<std::size_t>(max_line_bytes)) {
    return "is " + std::to_string(framed) + " bytes with line number and checksum; the machine takes " +
           std::to_string(max_line_bytes);
  }
  if (!std::all_of(command.begin(), command.end(), isPrintableAscii)) {
    return "has a byte that is not printable ASCII; expected G-code text";
  }
  if (command.find('*') != std::string::npos)
    return "has a '*', which marks a checksum; checksums are added here";
  if (command[0] == 'N') return "has a line number; lines are numbered here";
  if (std::isalpha(static_cast<unsigned char>(command[0])) == 0) {
    return "starts with '" + command.substr(0, 1) + "'; expected a command letter";
  }
  if (isCommand(command, "M110")) return "sets the line number, which belongs to the streamer";
  if (command.find("M110") != std::string::npos)
    return "has 'M110' in its text, which Marlin takes for the setting of a line number";
  if (command.find('\\') != std::string::npos)
    return "has a '\\', which Marlin leaves out of a line before it looks at the checksum";
  return {};
}

[[noreturn]] void throwUnreadable(const std::string& path, const char* why) {
  throw FileError("cannot read program " + path + ": " + why);
}

}  // namespace

std::optional<ProgramLine> ProgramCursor::next() {
  while (std::getline(*text_, raw_)) {
    ++text_line_;
    std::string_view line = raw_;
    const std::size_t comment = line.find(';');
    if (comment != std::string_view::npos) {
      readComment(line.substr(comment + 1));
      line = line.substr(0, comment);
    }
    line = trimmed(line);
    if (line.empty()) continue;
    const bool has_parentheses = line.find('(') != std::string_view::npos && !carriesText(line);
    ProgramLine found{has_parentheses ? withoutParentheses(line) : std::string(line), layer_};
    if (!found.command.empty()) return found;
  }
  return std::nullopt;
}

void ProgramCursor::readComment(std::string_view comment) {
  const auto mark = readLayerMark(trimmed(comment));
  if (!mark) return;
  layer_ = mark->is_next ? layer_ + 1 : mark->number.value_or(layer_);
}

StreamableProgram StreamableProgram::fromFile(const std::string& path, int max_line_bytes) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) throwUnreadable(path, std::strerror(errno));
  if (S_ISDIR(about.st_mode)) throwUnreadable(path, "it is a folder; expected a G-code file");
  StreamableProgram program;
  program.name_ = path;
  program.path_ = path;
  program.checked_ = stateOf(path);
  program.check(max_line_bytes);
  return program;
}

StreamableProgram StreamableProgram::fromText(const std::string& name, std::string text, int max_line_bytes) {
  StreamableProgram program;
  program.name_ = name;
  program.text_ = std::make_shared<const std::string>(std::move(text));
  program.check(max_line_bytes);
  return program;
}

ProgramCursor StreamableProgram::open() const {
  if (text_) return ProgramCursor(std::make_unique<std::istringstream>(*text_));
  auto file = std::make_unique<std::ifstream>(path_, std::ios::binary);
  if (!*file) throwUnreadable(path_, std::strerror(errno));
  return ProgramCursor(std::move(file));
}

std::optional<StreamableProgram::FileState> StreamableProgram::stateOf(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return std::nullopt;
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  return FileState{about.st_ino, about.st_size, about.st_mtim.tv_sec * kNanoseconds + about.st_mtim.tv_nsec};
}

bool StreamableProgram::hasChanged() const { return !text_ && !(stateOf(path_) == checked_); }

void StreamableProgram::check(int max_line_bytes) {
  ProgramCursor cursor = open();
  while (const auto line = cursor.next()) {
    const std::string defect = defectOf(line->command, max_line_bytes);
    if (!defect.empty()) {
      throw InvalidProgram(name_ + " line " + std::to_string(cursor.textLine()) + ": \"" +
                           line->command.substr(0, 40) + "\" " + defect);
    }
    ++lines_;
  }
  if (lines_ == 0) throw InvalidProgram(name_ + " has no command; expected G-code");
}

}  // namespace lamina
