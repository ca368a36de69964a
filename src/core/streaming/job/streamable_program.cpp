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
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "lamina/streaming/job/firmware_protocol.hpp"
#include "program/gcode/foreign_format.hpp"
#include "program/gcode/plain_command.hpp"
#include "program/gcode/slicer_comments.hpp"

namespace lamina {
namespace {

/// Commands whose argument is text, in which parentheses are no comment.
bool carriesText(std::string_view command) {
  constexpr std::array<std::string_view, 4> kCommands = {"M117", "M118", "M23 ", "M32 "};
  return std::any_of(kCommands.begin(), kCommands.end(),
                     [&](std::string_view name) { return command.substr(0, name.size()) == name; });
}

/// In quotes and in braces, which hold expressions of RepRapFirmware, parentheses are no comment.
std::string withoutParentheses(std::string_view command) {
  const bool has_quotes = std::count(command.begin(), command.end(), '"') % 2 == 0;
  std::string kept;
  int depth = 0;
  int braces = 0;
  bool is_quoted = false;
  for (const char c : command) {
    if (depth == 0 && c == '"' && has_quotes) is_quoted = !is_quoted;
    if (depth == 0 && !is_quoted) braces = std::max(0, braces + (c == '{' ? 1 : 0) - (c == '}' ? 1 : 0));
    const bool is_plain = !is_quoted && braces == 0;
    if (is_plain && c == '(') ++depth;
    if (depth == 0) kept += c;
    if (c == ')' && depth > 0) --depth;
  }
  return std::string(trimmed(kept));
}

/// Where a comment begins: at a ';' which no quotes enclose.
std::size_t commentOf(std::string_view line) {
  bool is_quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"') is_quoted = !is_quoted;
    if (line[at] == ';' && !is_quoted) return at;
  }
  // A quotation mark alone stands for inches.
  return is_quoted ? line.find(';') : std::string_view::npos;
}

std::size_t digitsAt(std::string_view line, std::size_t from) {
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  return static_cast<std::size_t>(
      std::find_if_not(line.begin() + static_cast<std::ptrdiff_t>(from), line.end(), isDigit) - line.begin() -
      static_cast<std::ptrdiff_t>(from));
}

/// Without a checksum behind a numbered line, if it is right.
std::string_view withoutChecksum(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos) return line;
  const std::size_t digits = digitsAt(line, star + 1);
  if (digits == 0 || digits > 3 || star + 1 + digits != line.size()) return line;
  unsigned sum = 0;
  for (const char byte : line.substr(0, star)) sum ^= static_cast<unsigned char>(byte);
  return std::stoul(std::string(line.substr(star + 1))) == sum ? line.substr(0, star) : line;
}

/// Without a line number: lines are numbered anew.
std::string_view withoutNumber(std::string_view line) {
  if (line.empty() || (line[0] != 'N' && line[0] != 'n')) return line;
  const std::size_t digits = digitsAt(line, 1);
  if (digits == 0) return line;
  return trimmed(withoutChecksum(line).substr(1 + digits));
}

/// A protocol that a program is checked for.
struct Checker {
  std::string name;
  std::shared_ptr<const FirmwareProtocol> protocol;
};

std::vector<Checker> checkersOf(const std::string& firmware) {
  std::vector<Checker> checkers;
  for (const std::string& name : firmwareProtocols().names()) {
    if (firmware == kAnyFirmware || firmware == name)
      checkers.push_back({name, firmwareProtocols().find(name)});
  }
  return checkers;
}

/// The names of the parts that a program defines for Klipper, line by line.
class DefinedParts {
 public:
  void read(const std::string& command) {
    if (has_begun_ || names.size() >= kMost) return;
    has_begun_ = command.compare(0, kBeginning.size(), kBeginning) == 0;
    if (command.compare(0, kDefinition.size(), kDefinition) != 0) return;
    const std::size_t name = command.find(kNameKey);
    if (name == std::string::npos) return;
    const std::size_t first = name + kNameKey.size();
    names.push_back(command.substr(first, command.find(' ', first) - first));
  }

  std::vector<std::string> names;

 private:
  static constexpr std::size_t kMost = 10000;  // as many as `cancel_part` can name
  static constexpr std::string_view kDefinition = "EXCLUDE_OBJECT_DEFINE ";
  static constexpr std::string_view kBeginning = "EXCLUDE_OBJECT_START ";
  static constexpr std::string_view kNameKey = "NAME=";
  bool has_begun_ = false;  ///< a part: what is defined from here on is none of the plate's
};

/// Looks at the first bytes and leaves them to be read: a pipe gives them once.
void requireText(std::istream& text, const std::string& name) {
  text.peek();
  std::array<char, 4> start{};
  const auto count = std::clamp<std::streamsize>(text.rdbuf()->in_avail(), 0, start.size());
  text.read(start.data(), count);
  for (std::streamsize i = 0; i < count; ++i) text.unget();
  requireTextOfGcode({start.data(), static_cast<std::size_t>(count)}, name);
}

[[noreturn]] void throwUnreadable(const std::string& path, const char* why) {
  throw FileError("cannot read program " + path + ": " + why);
}

}  // namespace

std::optional<ProgramLine> ProgramCursor::next() {
  while (std::getline(*text_, raw_)) {
    ++text_line_;
    bytes_read_ += raw_.size() + 1;
    std::string_view line = text_line_ == 1 ? withoutUtf8Mark(raw_) : raw_;
    const std::size_t comment = commentOf(line);
    if (comment != std::string_view::npos) {
      readComment(line.substr(comment + 1));
      line = line.substr(0, comment);
    }
    line = withoutNumber(trimmed(line));
    if (line.empty() || line == "%") continue;
    const bool has_parentheses = line.find('(') != std::string_view::npos && !carriesText(line);
    ProgramLine found{has_parentheses ? withoutParentheses(line) : std::string(line), layer_, 0.0};
    if (!found.command.empty()) return found;
  }
  return std::nullopt;
}

void ProgramCursor::readComment(std::string_view comment) {
  const auto mark = readLayerMark(trimmed(comment));
  if (!mark) return;
  layer_ = mark->is_next ? layer_ + 1 : mark->number.value_or(layer_);
}

StreamableProgram StreamableProgram::fromFile(const std::string& path, const StreamSettings& settings) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) throwUnreadable(path, std::strerror(errno));
  if (S_ISDIR(about.st_mode)) throwUnreadable(path, "it is a folder; expected a G-code file");
  StreamableProgram program;
  program.name_ = path;
  program.path_ = path;
  program.checked_ = stateOf(path);
  program.check(settings);
  return program;
}

StreamableProgram StreamableProgram::fromText(const std::string& name, std::string text,
                                              const StreamSettings& settings) {
  StreamableProgram program;
  program.name_ = name;
  program.text_ = std::make_shared<const std::string>(std::move(text));
  program.check(settings);
  return program;
}

StreamableProgram StreamableProgram::madeFrom(ProgramOrigin origin) const {
  StreamableProgram program = *this;
  program.origin_ = std::move(origin);
  return program;
}

ProgramCursor StreamableProgram::open() const { return ProgramCursor(openText()); }

std::unique_ptr<std::istream> StreamableProgram::openText() const {
  if (text_) return std::make_unique<std::istringstream>(*text_);
  requireReadable(path_);
  auto file = std::make_unique<std::ifstream>(path_, std::ios::binary);
  if (!*file) throwUnreadable(path_, std::strerror(errno));
  return file;
}

std::optional<StreamableProgram::FileState> StreamableProgram::stateOf(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return std::nullopt;
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  return FileState{about.st_ino, about.st_size, about.st_mtim.tv_sec * kNanoseconds + about.st_mtim.tv_nsec};
}

bool StreamableProgram::hasChanged() const { return !text_ && !(stateOf(path_) == checked_); }

void StreamableProgram::check(const StreamSettings& settings) {
  std::vector<Checker> checkers = checkersOf(settings.firmware);
  std::string last_defect;
  DefinedParts parts;
  std::unique_ptr<std::istream> text = openText();
  requireText(*text, name_);
  ProgramCursor cursor(std::move(text));
  while (const auto line = cursor.next()) {
    // A line that is plain G-code may be shown itself.
    if (!quotation_.isRecognised() && isPlainCommand(line->command)) quotation_.recognise();
    ++lines_;
    parts.read(line->command);
    const auto isMisread = [&](const Checker& checker) {
      const std::string defect = checker.protocol->defectOf(line->command, settings);
      if (defect.empty()) return false;
      last_defect = name_ + " line " + std::to_string(cursor.textLine()) + ": " +
                    quotation_.of(line->command) + " " + defect;
      defects_[checker.name] = last_defect;
      return true;
    };
    checkers.erase(std::remove_if(checkers.begin(), checkers.end(), isMisread), checkers.end());
    if (checkers.empty()) throw InvalidProgram(last_defect);
  }
  if (lines_ == 0) throw InvalidProgram(name_ + " has no command; expected G-code");
  defined_parts_ = std::make_shared<const std::vector<std::string>>(std::move(parts.names));
}

std::string StreamableProgram::defectFor(const std::string& protocol) const {
  const auto found = defects_.find(protocol);
  return found == defects_.end() ? std::string() : found->second;
}

}  // namespace lamina
