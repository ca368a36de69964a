// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// A letter and the number after it; no number for flags such as the axes of `G28 X`.
struct GcodeWord {
  char letter = 0;  ///< upper case
  std::optional<double> value;
};

/// One line of a program, split into its parts. The views are into the text that was parsed.
struct GcodeLine {
  std::size_t number = 0;                  ///< number of the line in the file, from 1
  std::optional<std::int64_t> sequence;    ///< number after N, if there is one
  std::vector<GcodeWord> words;            ///< without N and checksum; empty if the line is `is_other`
  std::vector<std::string_view> comments;  ///< after ; or within ( ), trimmed
  std::string_view command;                ///< the line without N, checksum and the comment after ;
  /// Whether the line has a command whose arguments are not words, or that Lamina does not know.
  bool is_other = false;
};

/// Splits lines of G-code into words and comments. Its memory is reused from line to line.
///
/// Words are parsed only for commands that move or change how motions are read: G0 to G6, G17 to G21, G28,
/// G90 to G92, M82, M83, and lines with coordinates alone. All other commands may have free text; such a line
/// is `is_other` and kept whole.
class GcodeLineParser {
 public:
  /// @param text  one line without its line break
  /// @throws InvalidProgram if a number is malformed, not finite or beyond 1e9, a character cannot start a
  ///   word, a comment is not closed, or the checksum after * is not the exclusive or of the bytes before it;
  ///   names the line
  /// @return valid until the next call
  const GcodeLine& parse(std::string_view text, std::size_t number);

 private:
  void take(std::string_view text);
  std::string_view withoutComment(std::string_view text);
  std::string_view withoutChecksum(std::string_view text) const;
  std::string_view withoutSequence(std::string_view text);
  void parseWords(std::string_view text);
  bool startsOther(std::string_view text) const;
  /// Removes a number from the beginning of the text, if there is one, and returns it.
  std::optional<double> takeNumber(std::string_view& text) const;
  [[noreturn]] void refuse(std::string_view what, std::string_view at) const;

  GcodeLine line_;
  Quotation quotation_;
};

}  // namespace lamina
