// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// A comment, and the number of its line.
struct RapidComment {
  std::string_view text;  ///< after the exclamation mark
  std::size_t line = 0;   ///< 1 based
};

/// Reads the text of a module word by word. Spaces and comments may be between any two words; comments are
/// kept until they are asked for. Names and words are returned in lower case.
class RapidCursor {
 public:
  /// @param name  of the module's file, for errors; both must outlive the cursor
  RapidCursor(std::string_view text, const std::string& name) : text_(text), name_(name) { skipBlanks(); }

  std::size_t line() const { return line_; }
  bool isAtEnd() const { return at_ == text_.size(); }
  /// Whether the next character is this one.
  bool isNext(char symbol) const { return at_ < text_.size() && text_[at_] == symbol; }

  /// Reads past a symbol if it comes next; returns whether it does.
  bool take(std::string_view symbol);
  /// Reads past a word if it comes next; returns whether it does.
  bool takeWord(std::string_view word);

  void expect(std::string_view symbol);
  void expectWord(std::string_view word);
  /// Reads a name or word.
  std::string takeName(std::string_view expected);
  double takeNumber(std::string_view expected);
  /// Reads a text in quotation marks; returns it without them.
  std::string takeString(std::string_view expected);

  std::vector<RapidComment> takeComments();

  /// States that the text has proved to be a module, so that messages may quote it.
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
