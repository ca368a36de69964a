// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/motion_text.hpp"

#include <string_view>

#include "gcode_rewrite/decimal_number.hpp"
#include "lamina/base/characters.hpp"

namespace lamina {
namespace {

bool isCoordinate(const PlacedWord& word) { return word.letter >= 'X' && word.letter <= 'Z'; }

/// Writes at the end of a text into room made once.
class TextTail {
 public:
  TextTail(std::string& text, std::size_t room) : text_(text) {
    const std::size_t size = text.size();
    text.resize(size + room);
    begin_ = at_ = text.data() + size;
  }
  ~TextTail() { text_.resize(static_cast<std::size_t>(at_ - text_.data())); }
  TextTail(const TextTail&) = delete;
  TextTail& operator=(const TextTail&) = delete;

  void put(char c) { *at_++ = c; }
  void put(std::string_view piece) {
    for (const char c : piece) *at_++ = c;
  }
  void put(char letter, double value, int decimals) {
    *at_++ = letter;
    at_ = writeFixed(at_, value, decimals);
  }
  void put(const Point3& point, int decimals) {
    put('X', point.x(), decimals);
    put(' ');
    put('Y', point.y(), decimals);
    put(' ');
    put('Z', point.z(), decimals);
  }
  void separate() {
    if (at_ != begin_ && !isBlank(at_[-1])) put(' ');
  }

 private:
  std::string& text_;
  char* begin_;
  char* at_;
};

constexpr std::size_t kMostNewWords = 5 * (kMostFixed + 2);

/// What stands between two words; where the word after it goes, so does the space before it.
std::string_view gapBefore(std::string_view gap, bool is_followed) {
  while (!is_followed && !gap.empty() && isBlank(gap.back())) gap.remove_suffix(1);
  return gap;
}

}  // namespace

void appendCoordinates(std::string& out, const Point3& point, int decimals) {
  TextTail(out, 3 * (kMostFixed + 2)).put(point, decimals);
}

void appendRewritten(std::string& out, const GcodeBlock& command, const NewWords& words, int decimals) {
  const std::string_view text = command.text();
  TextTail tail(out, text.size() + kMostNewWords);
  std::size_t copied = 0;
  const Point3* coordinates = words.coordinates;
  bool joins_next = false;  // coordinates were written, and nothing between them and the next word
  for (const PlacedWord& word : command) {
    const bool goes = isCoordinate(word) && words.coordinates != nullptr;
    tail.put(gapBefore(text.substr(copied, word.begin - copied), !goes || coordinates != nullptr));
    if (goes && coordinates != nullptr) {
      tail.separate();
      tail.put(*coordinates, decimals);
      coordinates = nullptr;
      joins_next = true;
    } else if (!goes) {
      if (joins_next) tail.separate();
      joins_next = false;
      if (word.letter == 'E' && words.extrusion)
        tail.put('E', *words.extrusion, kExtrusionDecimals);
      else if (word.letter == 'F' && words.feed)
        tail.put('F', *words.feed, kFeedDecimals);
      else
        tail.put(text.substr(word.begin, word.end - word.begin));
    }
    copied = word.end;
  }
  if (words.feed && command.find('F') == nullptr) {
    tail.put(' ');
    tail.put('F', *words.feed, kFeedDecimals);
  }
  tail.put(text.substr(copied));
}

void appendWithoutCoordinates(std::string& out, const GcodeBlock& command) {
  bool keeps_word = false;
  for (const PlacedWord& word : command) keeps_word |= !isCoordinate(word);
  if (!keeps_word) {
    out.append(";Deferred: ").append(command.text());
    return;
  }
  const std::string_view text = command.text();
  std::size_t copied = 0;
  for (const PlacedWord& word : command) {
    out.append(gapBefore(text.substr(copied, word.begin - copied), !isCoordinate(word)));
    if (!isCoordinate(word)) out.append(text.substr(word.begin, word.end - word.begin));
    copied = word.end;
  }
  out.append(text.substr(copied));
}

}  // namespace lamina
