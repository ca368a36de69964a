// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// A comment and where it stands.
struct RapidComment {
  std::string_view text;  ///< after the exclamation mark
  std::size_t line = 0;   ///< 1 based
};

/// Takes the text of a module apart, word by word. Blanks and comments may stand between any two; comments
/// are kept until they are asked for. Names and words are lower case.
class RapidCursor {
 public:
  /// @param name  of the module's file, for errors; both must outlive the cursor
  RapidCursor(std::string_view text, const std::string& name) : text_(text), name_(name) { skipBlanks(); }

  std::size_t line() const { return line_; }
  bool isAtEnd() const { return at_ == text_.size(); }
  /// Whether the next character is this one.
  bool isNext(char symbol) const { return at_ < text_.size() && text_[at_] == symbol; }

  /// Takes the symbol if it comes next.
  bool take(std::string_view symbol);
  /// Takes the word if it comes next.
  bool takeWord(std::string_view word);

  void expect(std::string_view symbol);
  void expectWord(std::string_view word);
  /// A name or a word.
  std::string takeName(std::string_view expected);
  double takeNumber(std::string_view expected);
  /// What stands between quotation marks.
  std::string takeString(std::string_view expected);

  std::vector<RapidComment> takeComments();

  /// The text is a module: from now on messages quote it.
  void recognise() { quotation_.recognise(); }

  /// @throws InvalidProgram "FILE line N: found '...'; expected EXPECTED"
  [[noreturn]] void refuse(std::string_view expected) const;
  /// @throws InvalidProgram "FILE line N: WHAT"
  [[noreturn]] void refuseAt(std::size_t line, const std::string& what) const;

 private:
  void skipBlanks();
  std::size_t nameLength() const;

  std::string_view text_;
  const std::string& name_;
  Quotation quotation_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<RapidComment> comments_;
};

}  // namespace lamina
