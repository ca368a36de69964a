// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_syntax.hpp"

#include <algorithm>
#include <array>

#include "streaming/firmware/grbl/grbl_words.hpp"

namespace lamina {
namespace {

// Characters of a line, without its end: LINE_BUFFER_SIZE of grbl 1.1, which does not count blanks; of
// grblHAL, which counts them; and maxLine of FluidNC.
constexpr std::size_t kLongestOfGrbl = 79;
constexpr std::size_t kLongestOfHal = 256;
constexpr std::size_t kLongestOfFluid = 254;

std::string tooLong(std::size_t length, std::size_t longest) {
  if (length <= longest) return {};
  return "is " + std::to_string(length) + " characters; the machine takes " + std::to_string(longest);
}

std::string asGiven(const GrblWord& word) {
  const int tenfold = word.tenfold();
  const std::string whole = word.letter + std::to_string(tenfold / 10);
  return tenfold % 10 == 0 ? whole : whole + "." + std::to_string(tenfold % 10);
}

bool isKnownG(int tenfold) {
  constexpr std::array<int, 41> kKnown = {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 281,
                                          300, 301, 382, 383, 384, 385, 400, 431, 490, 530, 540, 550, 560,
                                          570, 580, 590, 610, 800, 900, 910, 911, 920, 921, 930, 940};
  return std::find(kKnown.begin(), kKnown.end(), tenfold) != kKnown.end();
}

bool isKnownM(int tenfold, const GrblMachine& machine) {
  constexpr std::array<int, 9> kKnown = {0, 10, 20, 30, 40, 50, 80, 90, 300};
  constexpr int kMist = 70;
  constexpr int kParking = 560;
  if (tenfold == kMist) return machine.hasOption('M');
  if (tenfold == kParking) return machine.hasOption('R');
  return std::find(kKnown.begin(), kKnown.end(), tenfold) != kKnown.end();
}

std::string defectForClassic(std::string_view command, const GrblMachine& machine) {
  const auto length =
      command.size() - static_cast<std::size_t>(std::count(command.begin(), command.end(), ' '));
  std::string defect = tooLong(length, kLongestOfGrbl);
  if (!defect.empty()) return defect;
  if (command.find('/') != std::string_view::npos)
    return "has a '/', which grbl leaves out; expected the line to be kept or removed";
  const auto words = GrblWords::of(command);
  if (!words) return "is not letters with numbers, which grbl refuses (error:1 or error:2)";
  for (const GrblWord& word : *words) {
    constexpr std::string_view kLetters = "FGIJKLMNPRSTXYZ";
    const bool is_known = word.letter == 'G'   ? isKnownG(word.tenfold())
                          : word.letter == 'M' ? isKnownM(word.tenfold(), machine)
                                               : kLetters.find(word.letter) != std::string_view::npos;
    if (!is_known)
      return "has " +
             (word.letter == 'G' || word.letter == 'M' ? asGiven(word)
                                                       : std::string("the word ") + word.letter) +
             ", which " + machine.name() + " does not know (error:20)";
  }
  return {};
}

/// Extrusion goes with no motion of grbl's kin: their E is an output's number.
std::string defectOfExtrusion(std::string_view command) {
  const auto words = GrblWords::of(command);
  if (!words) return {};
  constexpr int kLastMotion = 30;
  const auto isMotion = [](const GrblWord& word) {
    return word.letter == 'G' && word.tenfold() <= kLastMotion;
  };
  const auto isExtrusion = [](const GrblWord& word) { return word.letter == 'E'; };
  const bool extrudes = std::any_of(words->begin(), words->end(), isMotion) &&
                        std::any_of(words->begin(), words->end(), isExtrusion);
  return extrudes ? "extrudes (E), which no machine of grbl's kin does" : "";
}

}  // namespace

std::string defectForAllGrbl(std::string_view command, int longest) {
  if (command.substr(0, 1) == "$")
    return "is a '$' line, which changes or moves the machine itself; expected it to be sent by hand";
  const std::size_t obeyed = command.find_first_of("!~?");
  if (obeyed != std::string_view::npos)
    return std::string("has a '") + command[obeyed] +
           "', which grbl takes for a command of its own wherever it stands";
  const auto isPrintable = [](char c) { return c >= ' ' && c <= '~'; };
  if (!std::all_of(command.begin(), command.end(), isPrintable))
    return "has a byte that is not printable ASCII, which grbl may take for a command of its own";
  const std::string defect =
      tooLong(command.size(), longest > 0 ? static_cast<std::size_t>(longest) : kLongestOfHal);
  return defect.empty() ? defectOfExtrusion(command) : defect;
}

std::string defectForGrbl(std::string_view command, const GrblMachine& machine) {
  std::string defect = defectForAllGrbl(command, 0);
  if (!defect.empty()) return defect;
  if (machine.dialect == GrblDialect::FluidNc) return tooLong(command.size(), kLongestOfFluid);
  return machine.dialect == GrblDialect::Grbl ? defectForClassic(command, machine) : std::string();
}

bool mayStandStill(std::string_view command) {
  const auto words = GrblWords::of(command);
  if (!words) return true;
  return std::any_of(words->begin(), words->end(), [](const GrblWord& word) {
    constexpr int kDwell = 40;
    return word.letter == 'M' || word.letter == 'T' || (word.letter == 'G' && word.tenfold() == kDwell);
  });
}

bool keepsLaserOn(std::string_view command) {
  constexpr int kOn = 30;
  const auto words = GrblWords::of(command);
  return words && std::any_of(words->begin(), words->end(), [](const GrblWord& word) {
           return word.letter == 'M' && word.tenfold() == kOn;
         });
}

}  // namespace lamina
