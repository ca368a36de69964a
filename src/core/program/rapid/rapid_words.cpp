// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/rapid_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "lamina/base/characters.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestName = 32;

constexpr std::array<std::string_view, 49> kReserved = {
    "alias",   "and",      "backward", "case",    "connect", "const",     "default", "div",       "do",
    "else",    "elseif",   "endfor",   "endfunc", "endif",   "endmodule", "endproc", "endrecord", "endtest",
    "endtrap", "endwhile", "error",    "exit",    "false",   "for",       "from",    "func",      "goto",
    "if",      "inout",    "local",    "mod",     "module",  "nostepin",  "not",     "noview",    "or",
    "pers",    "proc",     "raise",    "record",  "retry",   "return",    "step",    "test",      "then",
    "to",      "true",     "while",    "var"};

/// Instructions, functions and types of data that every controller has: a name of one's own would hide them.
constexpr std::array<std::string_view, 168> kPredefined = {"abs",
                                                           "accset",
                                                           "acos",
                                                           "actunit",
                                                           "add",
                                                           "aliasio",
                                                           "asin",
                                                           "atan",
                                                           "atan2",
                                                           "bool",
                                                           "break",
                                                           "byte",
                                                           "calcjointt",
                                                           "calcrobt",
                                                           "callbyvar",
                                                           "cirpathmode",
                                                           "cjointt",
                                                           "clear",
                                                           "clkreset",
                                                           "clkstart",
                                                           "clkstop",
                                                           "clock",
                                                           "close",
                                                           "confdata",
                                                           "confj",
                                                           "confl",
                                                           "cos",
                                                           "cpos",
                                                           "crobt",
                                                           "ctool",
                                                           "cwobj",
                                                           "deactunit",
                                                           "decr",
                                                           "defframe",
                                                           "dionum",
                                                           "distance",
                                                           "dnum",
                                                           "doutput",
                                                           "eoffsoff",
                                                           "eoffson",
                                                           "eoffsset",
                                                           "errnum",
                                                           "eulerzyx",
                                                           "exp",
                                                           "extjoint",
                                                           "idelete",
                                                           "idisable",
                                                           "ienable",
                                                           "incr",
                                                           "intnum",
                                                           "invertdo",
                                                           "iodev",
                                                           "isignaldi",
                                                           "isignaldo",
                                                           "isleep",
                                                           "itimer",
                                                           "iwatch",
                                                           "jointtarget",
                                                           "load",
                                                           "loaddata",
                                                           "mecunit",
                                                           "motionsup",
                                                           "moveabsj",
                                                           "movec",
                                                           "movecao",
                                                           "movecdo",
                                                           "moveextj",
                                                           "movej",
                                                           "movejao",
                                                           "movejdo",
                                                           "movel",
                                                           "movelao",
                                                           "moveldo",
                                                           "norient",
                                                           "num",
                                                           "numtostr",
                                                           "offs",
                                                           "open",
                                                           "opmode",
                                                           "orient",
                                                           "orientzyx",
                                                           "orobt",
                                                           "pathacclim",
                                                           "pdispoff",
                                                           "pdispon",
                                                           "pdispset",
                                                           "pos",
                                                           "pose",
                                                           "poseinv",
                                                           "posemult",
                                                           "posevect",
                                                           "pow",
                                                           "present",
                                                           "pulsedo",
                                                           "reltool",
                                                           "reset",
                                                           "resetretrycount",
                                                           "robjoint",
                                                           "robtarget",
                                                           "round",
                                                           "runmode",
                                                           "save",
                                                           "searchc",
                                                           "searchl",
                                                           "set",
                                                           "setao",
                                                           "setdo",
                                                           "setgo",
                                                           "shapedata",
                                                           "signalai",
                                                           "signalao",
                                                           "signaldi",
                                                           "signaldo",
                                                           "signalgi",
                                                           "signalgo",
                                                           "sin",
                                                           "singarea",
                                                           "softact",
                                                           "softdeact",
                                                           "speeddata",
                                                           "speedlim",
                                                           "sqrt",
                                                           "startmove",
                                                           "stop",
                                                           "stopmove",
                                                           "string",
                                                           "strlen",
                                                           "strpart",
                                                           "symnum",
                                                           "tan",
                                                           "testdi",
                                                           "tooldata",
                                                           "tperase",
                                                           "tpnum",
                                                           "tpreadfk",
                                                           "tpreadnum",
                                                           "tpwrite",
                                                           "triggc",
                                                           "triggdata",
                                                           "triggequip",
                                                           "triggint",
                                                           "triggio",
                                                           "triggj",
                                                           "triggl",
                                                           "triggspeed",
                                                           "trunc",
                                                           "tunereset",
                                                           "tuneservo",
                                                           "tunetype",
                                                           "unload",
                                                           "valtostr",
                                                           "velset",
                                                           "waitai",
                                                           "waitdi",
                                                           "waitdo",
                                                           "waitgi",
                                                           "waitgo",
                                                           "waitload",
                                                           "waitrob",
                                                           "waittime",
                                                           "waituntil",
                                                           "waitwobj",
                                                           "wobjdata",
                                                           "write",
                                                           "wzdisable",
                                                           "wzenable",
                                                           "wzstationary",
                                                           "zonedata"};

constexpr std::array<double, 24> kSpeeds = {5,    10,   20,   30,   40,   50,   60,   80,
                                            100,  150,  200,  300,  400,  500,  600,  800,
                                            1000, 1500, 2000, 2500, 3000, 4000, 5000, 7000};
constexpr std::array<int, 14> kZones = {0, 1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200};

std::optional<int> numberAfter(char letter, const std::string& name) {
  if (name.empty() || name.front() != letter) return std::nullopt;
  int value = 0;
  const auto result = std::from_chars(name.data() + 1, name.data() + name.size(), value);
  if (result.ec != std::errc{} || std::to_string(value) != name.substr(1)) return std::nullopt;
  return value;
}

}  // namespace

std::string rapidLevelTrigger(std::size_t level) { return "lamina_level_" + std::to_string(level + 1); }

void requireRapidName(const std::string& key, const std::string& name) {
  const bool is_name =
      !name.empty() && name.size() <= kLongestName && isLetter(name.front()) &&
      std::all_of(name.begin(), name.end(), [](char c) { return isLetter(c) || isDigit(c) || c == '_'; });
  if (!is_name)
    throw InvalidConfig(key + " is '" + name +
                        "'; must be a letter, then letters, digits and underscores, at most 32");
  if (std::find(kReserved.begin(), kReserved.end(), lowerCase(name)) != kReserved.end())
    throw InvalidConfig(key + " is '" + name + "', a word of RAPID; must be a name");
  if (std::find(kPredefined.begin(), kPredefined.end(), lowerCase(name)) != kPredefined.end())
    throw InvalidConfig(key + " is '" + name +
                        "', an instruction, function or type of RAPID; must be a name of its own");
}

std::optional<double> rapidSpeed(std::string_view name) {
  const std::optional<int> number = numberAfter('v', lowerCase(name));
  if (!number || std::find(kSpeeds.begin(), kSpeeds.end(), *number) == kSpeeds.end()) return std::nullopt;
  return *number;
}

bool isRapidZone(std::string_view name) {
  const std::string lower = lowerCase(name);
  if (lower == "fine") return true;
  const std::optional<int> number = numberAfter('z', lower);
  return number && std::find(kZones.begin(), kZones.end(), *number) != kZones.end();
}

}  // namespace lamina
