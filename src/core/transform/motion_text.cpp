// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "transform/motion_text.hpp"

#include "transform/decimal_number.hpp"

namespace lamina {
namespace {

bool isCoordinate(const PlacedWord& word) { return word.letter >= 'X' && word.letter <= 'Z'; }

bool isSpace(char c) { return c == ' ' || c == '\t'; }

/// Appends what stands between two words; where the word after it goes, so does the space before it.
void appendGap(std::string& out, std::string_view gap, bool is_followed) {
  while (!is_followed && !gap.empty() && isSpace(gap.back())) gap.remove_suffix(1);
  out.append(gap);
}

void appendWord(std::string& out, char letter, double value, int decimals) {
  out.push_back(letter);
  appendFixed(out, value, decimals);
}

}  // namespace

void appendCoordinates(std::string& out, const Point3& point, int decimals) {
  appendWord(out, 'X', point.x(), decimals);
  out.push_back(' ');
  appendWord(out, 'Y', point.y(), decimals);
  out.push_back(' ');
  appendWord(out, 'Z', point.z(), decimals);
}

void appendRewritten(std::string& out, const CommandLine& command, const NewWords& words, int decimals) {
  const std::string_view text = command.text();
  std::size_t copied = 0;
  const Point3* coordinates = words.coordinates;
  bool joins_next = false;  // coordinates were written, and nothing between them and the next word
  for (const PlacedWord& word : command) {
    const bool goes = isCoordinate(word) && words.coordinates != nullptr;
    const std::string_view gap = text.substr(copied, word.begin - copied);
    appendGap(out, gap, !goes || coordinates != nullptr);
    if (goes && coordinates != nullptr) {
      if (!out.empty() && !isSpace(out.back())) out.push_back(' ');
      appendCoordinates(out, *coordinates, decimals);
      coordinates = nullptr;
      joins_next = true;
    } else if (!goes) {
      if (joins_next && !isSpace(out.back())) out.push_back(' ');
      joins_next = false;
      if (word.letter == 'E' && words.extrusion)
        appendWord(out, 'E', *words.extrusion, kExtrusionDecimals);
      else if (word.letter == 'F' && words.feed)
        appendWord(out, 'F', *words.feed, kFeedDecimals);
      else
        out.append(text.substr(word.begin, word.end - word.begin));
    }
    copied = word.end;
  }
  if (words.feed && command.find('F') == nullptr) {
    out.push_back(' ');
    appendWord(out, 'F', *words.feed, kFeedDecimals);
  }
  out.append(text.substr(copied));
}

void appendWithoutCoordinates(std::string& out, const CommandLine& command) {
  bool keeps_word = false;
  for (const PlacedWord& word : command) keeps_word |= !isCoordinate(word);
  if (!keeps_word) {
    out.append(";Deferred: ").append(command.text());
    return;
  }
  const std::string_view text = command.text();
  std::size_t copied = 0;
  for (const PlacedWord& word : command) {
    appendGap(out, text.substr(copied, word.begin - copied), !isCoordinate(word));
    if (!isCoordinate(word)) out.append(text.substr(word.begin, word.end - word.begin));
    copied = word.end;
  }
  out.append(text.substr(copied));
}

}  // namespace lamina
