// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_resumption.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "streaming/firmware/grbl/grbl_words.hpp"

namespace lamina {
namespace {

// Above the rounding of reports and of steps.
constexpr double kSamePlace = 0.02;  // mm
// By which a line ends nearer than others: above the rounding to steps of 100 a millimetre, and of reports.
constexpr double kNearer = 0.01;  // mm

/// Lines that leave the machine where it is, from the one that led there on.
struct Stay {
  std::uint64_t last_run = 0;     ///< the last line that was certainly run, if the machine is there
  ExpectedPosition expected{""};  ///< behind that line
  std::string unrepeatable;       ///< a line behind it that must not be run twice; empty if there is none
};

/// Modes, speeds and switches, and motions to where the machine is: but no circle, probe, pause or tool.
bool mayBeRepeated(std::string_view command) {
  constexpr std::string_view kLetters = "GMFSPNXYZ";
  constexpr std::array<int, 18> kModes = {0,   10,  40,  170, 180, 190, 200, 210, 400,
                                          540, 550, 560, 570, 580, 590, 900, 910, 940};
  constexpr std::array<int, 6> kSwitches = {30, 40, 50, 70, 80, 90};
  const auto words = GrblWords::of(command);
  return words && std::all_of(words->begin(), words->end(), [&](const GrblWord& word) {
           if (word.letter == 'G')
             return std::find(kModes.begin(), kModes.end(), word.tenfold()) != kModes.end();
           if (word.letter == 'M')
             return std::find(kSwitches.begin(), kSwitches.end(), word.tenfold()) != kSwitches.end();
           return kLetters.find(word.letter) != std::string_view::npos;
         });
}

/// Whether a program has set a feed, and the machine has none any more, as after a reset.
bool hasLostItsFeed(std::string_view modes, bool has_set_feed) {
  const std::size_t feed = modes.find(" F");
  return has_set_feed && feed != std::string_view::npos && modes.substr(feed, 3) == " F0" &&
         modes.substr(feed + 3, 1).find_first_of(".123456789") == std::string_view::npos;
}

std::string linesText(const UnfinishedLines& unfinished) {
  return "lines " + std::to_string(unfinished.taken_through) + " to " +
         std::to_string(unfinished.sent_through);
}

GrblResumption refusedBecause(const std::string& why) {
  GrblResumption resumption;
  resumption.refusal = why + "; lamina resume makes a program of the rest, once somebody has looked";
  return resumption;
}

/// The stays of the lines that may have been the last, and whether a feed was set in or before them.
struct Candidates {
  std::vector<Stay> stays;
  bool has_set_feed = false;
};

Candidates candidatesOf(const StreamableProgram& program, const UnfinishedLines& unfinished,
                        std::string_view modes) {
  Candidates found;
  ExpectedPosition expected(modes);
  ProgramCursor cursor = program.open();
  for (std::uint64_t number = 1; number <= unfinished.sent_through; ++number) {
    const auto line = cursor.next();
    if (!line) break;
    const ExpectedPosition before = expected;
    expected.follow(line->command);
    if (number <= unfinished.taken_through && line->command.find('F') != std::string::npos)
      found.has_set_feed = true;
    const bool is_stay = before.places() == expected.places() && !found.stays.empty();
    if (!is_stay) {
      // Only the last stay before the lines in doubt is of interest.
      if (number <= unfinished.taken_through) found.stays.clear();
      found.stays.push_back({number, expected, ""});
    } else if (number <= unfinished.taken_through) {
      found.stays.back().last_run = number;
      found.stays.back().expected = expected;
    } else if (found.stays.back().unrepeatable.empty() && !mayBeRepeated(line->command)) {
      found.stays.back().unrepeatable =
          "line " + std::to_string(number) + ", " + program.quotation().of(line->command);
    }
  }
  return found;
}

/// The stays that the place does not distinguish from the nearest.
std::vector<const Stay*> staysAt(const std::vector<Stay>& stays, const GrblAxes& work) {
  double nearest = kSamePlace;
  for (const Stay& stay : stays)
    nearest = std::min(nearest, stay.expected.distanceFrom(work).value_or(kSamePlace));
  std::vector<const Stay*> here;
  for (const Stay& stay : stays) {
    const auto distance = stay.expected.distanceFrom(work);
    if (distance && *distance <= kSamePlace && *distance < nearest + kNearer) here.push_back(&stay);
  }
  return here;
}

}  // namespace

GrblResumption resumptionOf(const StreamableProgram& program, const UnfinishedLines& unfinished,
                            std::string_view modes, const GrblAxes& work) {
  const Candidates candidates = candidatesOf(program, unfinished, modes);
  if (hasLostItsFeed(modes, candidates.has_set_feed))
    return refusedBecause("the machine has forgotten its feed: it was reset, and may have lost its position");
  const std::vector<const Stay*> here = staysAt(candidates.stays, work);
  if (here.size() != 1)
    return refusedBecause("the machine stands where " + std::to_string(here.size()) + " of " +
                          linesText(unfinished) +
                          " end; expected exactly one of them, by which to identify the last one");
  if (!here.front()->unrepeatable.empty())
    return refusedBecause("it is not known whether " + here.front()->unrepeatable +
                          " was run, which leaves no trace and must not be run twice");
  return {here.front()->last_run, here.front()->expected, ""};
}

}  // namespace lamina
