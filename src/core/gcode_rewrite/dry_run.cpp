// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/dry_run.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "decimal_number.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "program/gcode/plain_command.hpp"

namespace lamina {

/// A word of a command, as it stands there.
struct GcodeWordText {
  char letter = 0;  ///< upper case
  bool has_value = false;
  double value = 0.0;
  std::string_view text;  ///< with its letter
};

namespace {

/// What a dry run makes of a command.
enum class DryVerdict : std::uint8_t {
  Keep,     ///< it moves, waits, reports or configures, and switches nothing of a process on
  Process,  ///< it is of the process, or makes the firmware run it
  Target,   ///< the same, unless its target is 0
  Unknown,
};

template <class Value, std::size_t count>
bool isIn(const std::array<Value, count>& all, const Value& value) {
  return std::find(all.begin(), all.end(), value) != all.end();
}

std::string upperCase(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

// 26 prints a pattern and 76 heats. 6 is a direct move of steppers, without a place to go to.
/// @param code  number of a G command without its fraction
DryVerdict verdictOnG(int code) {
  constexpr std::array kKept = {0,  1,  2,  3,  4,  5,  10, 12, 17, 18, 19, 20, 21, 27, 28,
                                29, 30, 31, 32, 33, 34, 38, 40, 43, 49, 50, 53, 54, 55, 56,
                                57, 58, 59, 60, 61, 64, 68, 69, 80, 90, 91, 92, 93, 94, 98};
  constexpr std::array kProcess = {11, 22, 23, 26, 76};
  if (isIn(kKept, code)) return DryVerdict::Keep;
  return isIn(kProcess, code) ? DryVerdict::Process : DryVerdict::Unknown;
}

/// @param code  number of an M command
DryVerdict verdictOnM(int code) {
  constexpr std::array kKept = {0,   1,   2,   5,   9,   17,  18,  30,  73,  75,  76,  77,  78,  82,  83,
                                84,  85,  105, 107, 112, 114, 115, 117, 118, 119, 120, 121, 154, 155, 201,
                                202, 203, 204, 205, 211, 220, 400, 401, 402, 413, 420, 428, 429, 486, 556,
                                557, 558, 561, 564, 566, 569, 593, 665, 666, 851, 906, 907, 913, 914, 915};
  constexpr std::array kTargets = {104, 106, 109, 140, 141, 190, 191};
  constexpr std::array kProcess = {3,   4,   6,   7,   8,   10,  11,  101, 103, 108, 116,
                                   126, 127, 143, 193, 207, 208, 209, 221, 302, 303, 306,
                                   563, 567, 568, 572, 600, 603, 701, 702, 703, 900};
  if (isIn(kKept, code)) return DryVerdict::Keep;
  if (isIn(kTargets, code)) return DryVerdict::Target;
  return isIn(kProcess, code) ? DryVerdict::Process : DryVerdict::Unknown;
}

/// @param name  first word of a command that is no letter with a number, in any case
DryVerdict verdictOnName(std::string_view name) {
  constexpr std::array<std::string_view, 16> kKept = {
      "BED_MESH_CALIBRATE",   "BED_MESH_CLEAR",        "BED_MESH_PROFILE",   "CLEAR_PAUSE",
      "EXCLUDE_OBJECT",       "EXCLUDE_OBJECT_DEFINE", "EXCLUDE_OBJECT_END", "EXCLUDE_OBJECT_START",
      "QUAD_GANTRY_LEVEL",    "RESTORE_GCODE_STATE",   "SAVE_GCODE_STATE",   "SET_GCODE_OFFSET",
      "SET_PRINT_STATS_INFO", "SET_VELOCITY_LIMIT",    "TURN_OFF_HEATERS",   "Z_TILT_ADJUST"};
  constexpr std::array<std::string_view, 9> kProcess = {
      "ACTIVATE_EXTRUDER", "SET_FAN_SPEED",    "SET_HEATER_TEMPERATURE", "SET_PIN",   "SET_PRESSURE_ADVANCE",
      "SET_RETRACTION",    "TEMPERATURE_WAIT", "SYNC_EXTRUDER_MOTION",   "FORCE_MOVE"};
  const std::string upper = upperCase(name);
  if (isIn(kKept, std::string_view(upper))) return DryVerdict::Keep;
  return isIn(kProcess, std::string_view(upper)) ? DryVerdict::Process : DryVerdict::Unknown;
}

/// The command that sets a target without a wait for it, of one that does or does not: M104 of M109.
int withoutWait(int code) {
  constexpr int kNozzle = 109;
  constexpr int kBed = 190;
  constexpr int kChamber = 191;
  if (code == kNozzle) return 104;
  if (code == kBed) return 140;
  return code == kChamber ? 141 : code;
}

/// Whether it begins a statement of a language in G-code (`if`, `while`), without which the lines within it
/// mean something else.
bool isStatement(std::string_view name) {
  constexpr std::array<std::string_view, 6> kStatements = {"IF",    "ELIF",  "ELSE",
                                                           "WHILE", "BREAK", "CONTINUE"};
  return isIn(kStatements, std::string_view(upperCase(name)));
}

constexpr std::string_view kModal = "XYZABCUVWIJKREFS";  // which lines begin with that go on with a motion

/// The words of a command; nothing if it holds anything else.
std::optional<std::vector<GcodeWordText>> wordsOf(std::string_view text) {
  std::vector<GcodeWordText> words;
  const auto skipBlanks = [&](std::size_t at) {
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
    return at;
  };
  for (std::size_t at = skipBlanks(0); at < text.size(); at = skipBlanks(at)) {
    if (std::isalpha(static_cast<unsigned char>(text[at])) == 0) return std::nullopt;
    GcodeWordText word;
    word.letter = upper(text[at]);
    const std::size_t number = skipBlanks(at + 1);
    const DecimalNumber read = readDecimal(text.substr(number));
    word.has_value = read.length > 0;
    word.value = read.value;
    const std::size_t end = word.has_value ? number + read.length : at + 1;
    if (word.has_value && !std::isfinite(word.value)) return std::nullopt;
    word.text = text.substr(at, end - at);
    words.push_back(word);
    at = end;
  }
  return words;
}

/// Where a comment begins: at a ';' that no quotes enclose.
std::size_t commentBegin(std::string_view line) {
  bool is_quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"') is_quoted = !is_quoted;
    if (line[at] == ';' && !is_quoted) return at;
  }
  return is_quoted ? std::min(line.find(';'), line.size()) : line.size();
}

/// Without its number and checksum, which would be wrong.
std::string_view unnumbered(std::string_view command) {
  if (command.size() < 2 || upper(command[0]) != 'N' || !isDigit(command[1])) return command;
  std::size_t at = 1;
  while (at < command.size() && isDigit(command[at])) ++at;
  command = command.substr(at);
  const std::size_t star = command.rfind('*');
  if (star != std::string_view::npos && star + 1 < command.size() &&
      std::all_of(command.begin() + static_cast<std::ptrdiff_t>(star) + 1, command.end(), isDigit))
    command = command.substr(0, star);
  return trimmed(command);
}

/// Without comments in parentheses.
std::string unbracketed(std::string_view command) {
  std::string kept;
  int depth = 0;
  for (const char c : command) {
    if (c == '(') ++depth;
    if (depth == 0) kept += c;
    if (c == ')') depth = std::max(0, depth - 1);
  }
  return std::string(trimmed(kept));
}

bool isCode(const GcodeWordText& word) {
  return word.letter == 'G' || word.letter == 'M' || word.letter == 'T';
}

/// The number of a command without its fraction; -1 if it has none.
int codeOf(const GcodeWordText& word) {
  constexpr double kMost = 99999.0;
  return word.has_value && word.value >= 0.0 && word.value <= kMost ? static_cast<int>(word.value) : -1;
}

bool isG(const GcodeWordText& word, int code) { return word.letter == 'G' && codeOf(word) == code; }

bool isMotionWord(const GcodeWordText& word) {
  return isG(word, 0) || isG(word, 1) || isG(word, 2) || isG(word, 3) || isG(word, 5);
}

/// The number of a command such as "M117 hello"; nothing if it is no M command.
std::optional<int> machineCodeOf(std::string_view text) {
  if (text.size() < 2 || upper(text[0]) != 'M' || !isDigit(text[1])) return std::nullopt;
  return codeOf({'M', true, readDecimal(text.substr(1)).value, {}});
}

/// Whether a G code changes how a motion on its line is read, and does not take its words.
bool keepsMotion(int code) {
  return (code >= 17 && code <= 21) || code == 40 || code == 43 || code == 49 || (code >= 53 && code <= 59) ||
         code == 61 || code == 64 || code == 80 || (code >= 90 && code <= 98 && code != 92);
}

/// M codes that may stand on a line with a motion.
bool isFlag(int code) { return code <= 9 || code == 30; }

/// What follows is for people, or the names of parts.
bool carriesText(int code) { return code == 117 || code == 118 || code == 486; }

/// Of lasers and spindles, which may be on from before: what would switch one on switches it off.
constexpr const char* kBeamOff = "M5";
bool switchesBeam(int code) { return code == 3 || code == 4; }

bool isName(std::string_view text) {
  return text.size() > 1 && std::isalpha(static_cast<unsigned char>(text[1])) != 0;
}

/// Whether a G, M or T with a number stands behind the first word, other than within quotes. Quotes that do
/// not end enclose nothing.
bool holdsFurtherCode(std::string_view text) {
  const bool has_quotes = std::count(text.begin(), text.end(), '"') % 2 == 0;
  bool is_quoted = false;
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (text[at] == '"') is_quoted = !is_quoted;
    const char letter = upper(text[at]);
    const char before = text[at - 1];
    const bool is_within_name = std::isalpha(static_cast<unsigned char>(before)) != 0 || before == '_';
    const bool is_letter = letter == 'G' || letter == 'M' || letter == 'T';
    if (!(is_quoted && has_quotes) && is_letter && !is_within_name && isDigit(text[at + 1])) return true;
  }
  return false;
}

bool holdsExpression(std::string_view text) { return text.find_first_of("[#{") != std::string_view::npos; }

bool holdsTwice(const std::vector<GcodeWordText>& words, std::string_view letters) {
  return std::any_of(letters.begin(), letters.end(), [&](char letter) {
    return std::count_if(words.begin(), words.end(),
                         [&](const GcodeWordText& word) { return word.letter == letter; }) > 1;
  });
}

bool isAxisText(const std::string& word) {
  return std::string_view("XYZABCUVW").find(upper(word.front())) != std::string_view::npos;
}

/// Commands that without a word of an axis are of all axes: G28, G30, G61 and G92, but not G92.1.
bool isOfAllAxes(const std::string& word) {
  const double value =
      upper(word.front()) == 'G' ? readDecimal(trimmed(std::string_view(word).substr(1))).value : 0.0;
  return value == 28.0 || value == 30.0 || value == 61.0 || value == 92.0;
}

const GcodeWordText* find(const std::vector<GcodeWordText>& words, char letter) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const GcodeWordText& word) { return word.letter == letter; });
  return found == words.end() ? nullptr : &*found;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

/// A command of letters with numbers.
struct DryRun::Block {
  std::string_view text;
  std::vector<GcodeWordText> words;

  bool has(char letter, int code) const {
    return std::any_of(words.begin(), words.end(), [&](const GcodeWordText& word) {
      return word.letter == letter && codeOf(word) == code;
    });
  }
  /// Of G and M.
  auto codes() const {
    return std::count_if(words.begin(), words.end(),
                         [](const GcodeWordText& word) { return word.letter == 'G' || word.letter == 'M'; });
  }
  /// Whether its other words are those of a motion: also where the motion is that of a line before.
  bool moves() const {
    return std::none_of(words.begin(), words.end(), [](const GcodeWordText& word) {
      return word.letter == 'G' && !isMotionWord(word) && !keepsMotion(codeOf(word));
    });
  }
};

void describe(SettingsSchema& schema, DryRunSettings& settings) {
  schema.number("dry.speed", settings.speed, {0.01, 3.0},
                "Share of the programmed feeds at which a dry run goes.");
  schema.text("dry.extrusion", settings.extrusion, "Letters of extruder axes, which a dry run leaves out.");
  schema.choice<UnknownCommand>(
      "dry.unknown", settings.unknown,
      {{"leave_out", UnknownCommand::LeaveOut}, {"refuse", UnknownCommand::Refuse}},
      "What a dry run makes of commands that may switch something on, such as macros.");
}

DryRun::DryRun(const DryRunSettings& settings) : settings_(settings) {
  SettingsSchema schema;
  describe(schema, settings_);
  schema.validate();
  for (const char letter : settings_.extrusion)
    if (std::string_view("ABCDEUVW").find(letter) == std::string_view::npos)
      throw InvalidConfig("dry.extrusion is '" + settings_.extrusion + "'; must be letters of ABCDEUVW");
}

std::optional<std::string> DryRun::line(std::string_view text) {
  ++number_;
  const std::size_t begin = commentBegin(text);
  const std::string_view comment = trimmed(text.substr(begin));
  const std::string_view asked = unnumbered(trimmed(text.substr(0, begin)));
  if (asked.empty() || asked.front() == '%') return std::string(trimmed(text));
  if (isPlainCommand(asked)) quotation_.recognise();
  ++report_.lines;
  const std::optional<std::string> kept = command(asked);
  if (!kept && comment.empty()) return std::nullopt;
  if (!kept) return std::string(comment);
  return *kept + (comment.empty() ? "" : " " + std::string(comment));
}

std::optional<std::string> DryRun::command(std::string_view text) {
  const std::optional<int> machine_code = machineCodeOf(text);
  if (machine_code && carriesText(*machine_code)) {
    constexpr int kMessage = 117;
    const bool may_end = *machine_code != kMessage || text.find('"') != std::string_view::npos;
    if (may_end && holdsFurtherCode(text))
      refuse("holds a further command behind its text; expected it on a line by itself", text);
    return std::string(text);
  }
  const std::string plain = unbracketed(text);
  if (plain.empty()) return std::nullopt;
  if (isName(plain)) return unknown(plain);
  const std::optional<std::vector<GcodeWordText>> words = wordsOf(plain);
  if (words && isCode(words->front())) return coded({plain, *words});
  if (words && kModal.find(words->front().letter) != std::string_view::npos) return motion({plain, *words});
  if (machine_code) {
    const bool is_kept = verdictOnM(*machine_code) == DryVerdict::Keep;
    if (is_kept && (holdsFurtherCode(plain) || holdsExpression(plain)))
      refuse("holds a further command or an expression; expected one command that can be read", plain);
    return machineCommand(*machine_code, {plain, {}});
  }
  if (upper(plain.front()) == 'T') return takenOut();
  if (kModal.find(upper(plain.front())) != std::string_view::npos || upper(plain.front()) == 'G')
    refuse("holds more than letters with numbers; expected a motion that can be run dry", plain);
  return unknown(plain);
}

std::optional<std::string> DryRun::coded(const Block& block) {
  const GcodeWordText& first = block.words.front();
  if (first.letter == 'T' && block.codes() == 0) return takenOut();
  if (first.letter == 'M' && block.codes() == 1) return machineCommand(codeOf(first), block);
  for (const GcodeWordText& word : block.words) {
    if (word.letter == 'G' && verdictOnG(codeOf(word)) == DryVerdict::Process && block.codes() == 1)
      return takenOut();
    if (isCode(word)) requireReadable(word, block);
  }
  return block.has('G', 10) ? offset(block) : motion(block);
}

void DryRun::requireReadable(const GcodeWordText& word, const Block& block) const {
  if (word.letter == 'G' && verdictOnG(codeOf(word)) == DryVerdict::Unknown)
    refuse("is not known to a dry run; it may change how motions are read", block.text);
  const bool is_of_process = word.letter == 'G' && verdictOnG(codeOf(word)) == DryVerdict::Process;
  if (is_of_process || (word.letter == 'M' && !isFlag(codeOf(word))))
    refuse("holds several commands, one with words of its own; expected it on a line by itself", block.text);
}

std::optional<std::string> DryRun::motion(const Block& block) {
  std::vector<std::string> kept;
  kept.reserve(block.words.size());
  bool has_extruder = false;
  for (const GcodeWordText& word : block.words) {
    if (std::optional<std::string> text = keptWord(word, block))
      kept.push_back(*std::move(text));
    else
      has_extruder = has_extruder || settings_.extrusion.find(word.letter) != std::string::npos;
  }
  const std::size_t taken = block.words.size() - kept.size();
  report_.process += taken;
  // What was for the extruder alone, such as a place that is set, would without its word be for all axes.
  if (has_extruder && std::none_of(kept.begin(), kept.end(), isAxisText))
    kept.erase(std::remove_if(kept.begin(), kept.end(), isOfAllAxes), kept.end());
  if (kept.empty()) return std::nullopt;
  std::string line = joined(kept);
  if (taken > 0 && line == motion_) return std::nullopt;
  for (const GcodeWordText& word : block.words)
    if (isMotionWord(word)) motion_ = word.text;
  return line;
}

std::optional<std::string> DryRun::keptWord(const GcodeWordText& word, const Block& block) {
  const GcodeWordText& front = block.words.front();
  // Of Marlin: whether the probe is stowed between places.
  const bool is_probing = word.letter == 'E' && block.codes() == 1 && (isG(front, 29) || isG(front, 30));
  if (settings_.extrusion.find(word.letter) != std::string::npos && !is_probing) return std::nullopt;
  if (word.letter == 'T') return std::nullopt;
  if (word.letter == 'M') {
    const DryVerdict verdict = verdictOnM(codeOf(word));
    if (switchesBeam(codeOf(word))) return beamOff();
    return verdict == DryVerdict::Keep ? std::optional(std::string(word.text)) : std::nullopt;
  }
  if (!block.moves()) return std::string(word.text);
  if (word.letter == 'S') {
    requireNoHoming(word, block);
    return std::nullopt;
  }
  return word.letter == 'F' && word.has_value ? scaledFeed(word) : std::string(word.text);
}

/// RepRapFirmware homes by S1 and moves single motors by S2; grbl's S is a power.
void DryRun::requireNoHoming(const GcodeWordText& word, const Block& block) const {
  constexpr double kMostKinds = 4.0;
  const bool may_home = word.has_value && word.value >= 1.0 && word.value <= kMostKinds;
  if (may_home && !has_beam_ && !block.has('M', 3) && !block.has('M', 4))
    refuse("has S in a motion, which may be a homing one or a power; expected H for a homing motion",
           block.text);
}

std::string DryRun::scaledFeed(const GcodeWordText& word) const {
  if (settings_.speed == 1.0) return std::string(word.text);
  constexpr int kDecimals = 6;
  std::string text = "F";
  try {
    appendFixed(text, word.value * settings_.speed, kDecimals);
  } catch (const InvalidInput&) {
    refuse("is a feed of more digits than a program may hold", word.text);
  }
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

/// G10: a retraction by the firmware, temperatures and offsets of a tool, or the origin of coordinates.
std::optional<std::string> DryRun::offset(const Block& block) {
  if (block.codes() > 1) refuse("holds several commands; expected G10 on a line by itself", block.text);
  const GcodeWordText* const kind = find(block.words, 'L');
  const bool is_of_origin = kind != nullptr && (kind->value == 2.0 || kind->value == 20.0);
  if (is_of_origin && !holdsTwice(block.words, "L")) return std::string(block.text);
  std::vector<std::string> kept;
  bool sets_offset = false;
  for (const GcodeWordText& word : block.words) {
    if (word.letter == 'R' || word.letter == 'S' || word.letter == 'T') continue;
    kept.emplace_back(word.text);
    sets_offset = sets_offset || std::string_view("XYZUVW").find(word.letter) != std::string_view::npos;
  }
  report_.process += block.words.size() - kept.size();
  if (sets_offset) return joined(kept);
  if (kept.size() == block.words.size()) ++report_.process;
  return std::nullopt;
}

std::optional<std::string> DryRun::machineCommand(int code, const Block& block) {
  if (switchesBeam(code)) return beamOff();
  const DryVerdict verdict = verdictOnM(code);
  if (verdict == DryVerdict::Keep) return std::string(block.text);
  if (verdict == DryVerdict::Unknown) return unknown(block.text);
  if (verdict == DryVerdict::Process) return takenOut();
  const GcodeWordText* const target = find(block.words, 'S');
  const bool is_off = target != nullptr && target->has_value && target->value == 0.0 &&
                      find(block.words, 'R') == nullptr && find(block.words, 'B') == nullptr;
  // What else stands there may switch on: T and H of M106 make a fan follow a heater, its T its speed.
  constexpr int kFan = 106;
  const std::string_view letters = code == kFan ? "SP" : "STPH";
  if (!is_off || holdsTwice(block.words, letters)) return takenOut();
  std::vector<std::string> kept = {"M" + std::to_string(withoutWait(code))};
  for (const GcodeWordText& word : block.words)
    if (letters.find(word.letter) != std::string_view::npos) kept.emplace_back(word.text);
  return joined(kept);
}

std::optional<std::string> DryRun::unknown(std::string_view text) {
  const std::string_view name = text.substr(0, text.find_first_of(" \t="));
  if (isStatement(name))
    refuse("is a statement, without which the lines within it mean something else", text);
  const DryVerdict verdict = verdictOnName(name);
  if (verdict == DryVerdict::Keep) return std::string(text);
  if (verdict == DryVerdict::Process) return takenOut();
  if (settings_.unknown == UnknownCommand::Refuse)
    refuse("is not known to switch nothing on; dry.unknown=leave_out leaves it out", text);
  ++report_.unknown;
  if (report_.first_unknown.empty())
    report_.first_unknown = "line " + std::to_string(number_) + ": " + quotation_.of(text);
  return std::nullopt;
}

std::string DryRun::beamOff() {
  has_beam_ = true;
  ++report_.process;
  return kBeamOff;
}

std::optional<std::string> DryRun::takenOut() {
  ++report_.process;
  return std::nullopt;
}

void DryRun::refuse(const std::string& why, std::string_view text) const {
  throw InvalidProgram("line " + std::to_string(number_) + ": " + quotation_.of(text) + " " + why);
}

std::string toText(const DryRunReport& report) {
  std::string text =
      "dry run: " + std::to_string(report.process) + " commands and words of the process taken out";
  if (report.unknown > 0)
    text += ", " + std::to_string(report.unknown) +
            " commands left out that are not known to switch nothing on, the first in " +
            report.first_unknown;
  return text;
}

DryRunReport writeDryRun(std::istream& program, const std::string& dry, const DryRunSettings& settings) {
  DryRun run(settings);
  AtomicFile file(dry);
  for (std::string line; std::getline(program, line);)
    if (const std::optional<std::string> kept = run.line(line)) file.write(*kept + "\n");
  file.commit();
  return run.report();
}

}  // namespace lamina
