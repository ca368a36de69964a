// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// A word, with the positions of its letter and its number in the line.
struct PlacedWord {
  char letter = 0;  ///< upper case
  bool has_value = false;
  double value = 0.0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// What comes first in a line.
enum class LineStart {
  Blank,
  Comment,
  G,
  M,
  Coordinate,  ///< a coordinate without a motion command
  Other,
};

/// A block (line) of G-code, parsed in place and fast enough for files of many millions of lines. All words
/// are parsed of commands that move or set positions (G0 to G3, G10, G28, G92); of other commands only letter
/// and number.
class GcodeBlock {
 public:
  /// @param line  without its line feed; must outlive the next calls
  /// @throws InvalidProgram naming the line if a word of such a command is malformed or occurs twice, or if
  ///   the line has a checksum, which would be wrong once the line is rewritten
  LineStart read(std::string_view line, std::size_t number);

  LineStart start() const { return start_; }
  std::string_view text() const { return text_; }
  std::size_t number() const { return number_; }
  int code() const { return code_; }  ///< number of G or M; -1 if it has none, or one with a fraction
  /// Text after the first semicolon, of a comment line or a line whose words are parsed.
  std::string_view comment() const { return comment_; }
  std::size_t wordsEnd() const { return words_end_; }  ///< one past the last word

  const PlacedWord* begin() const { return words_.data(); }
  const PlacedWord* end() const { return words_.data() + count_; }
  /// The word with this letter; null if there is none.
  const PlacedWord* find(char letter) const {
    const std::uint8_t index = index_[static_cast<std::size_t>(letter - 'A')];
    return index == kNoWord ? nullptr : &words_[index];
  }
  bool hasAny(std::string_view letters) const;

  /// The line as a message may quote it: empty unless a line before it was plain G-code.
  std::string quoted() const { return quotation_.of(text_); }

 private:
  LineStart take(std::string_view line);
  void setCode(double number);
  void readWords(std::size_t at);
  std::size_t readWord(std::size_t at);
  [[noreturn]] void refuse(std::string_view what, std::size_t at) const;

  static constexpr std::size_t kMostWords = 26;  // no letter stands twice
  static constexpr std::uint8_t kNoWord = 255;
  Quotation quotation_;
  std::string_view text_;
  std::string_view comment_;
  std::size_t number_ = 0;
  LineStart start_ = LineStart::Blank;
  int code_ = -1;
  std::size_t words_end_ = 0;
  std::size_t count_ = 0;
  std::array<PlacedWord, kMostWords> words_;
  std::array<std::uint8_t, 26> index_{};
};

}  // namespace lamina
