// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// Walks through the words of a text mesh file. Lines are counted only when an error needs one.
class TextCursor {
 public:
  TextCursor(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word, across lines; empty at the end.
  std::string_view word();
  /// The next word of this line; empty at its end, where the cursor stays.
  std::string_view wordInLine();
  void skipLine();
  bool isAtEnd() const { return position_ >= text_.size(); }
  std::size_t position() const { return position_; }

  /// The next word as a finite number, across lines.
  double number();
  /// The next word as a finite number, in this line.
  double numberInLine();

  /// The file is a mesh: from now on messages quote it.
  void recognise() { quotation_.recognise(); }
  /// A word of the file, for messages.
  std::string quoted(std::string_view word) const { return quotation_.of(word); }

  /// @throws InvalidMesh "name:line: what"
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  double parse(std::string_view word) const;

  std::string_view text_;
  const std::string& name_;
  Quotation quotation_;
  std::size_t position_ = 0;
};

/// Whether the word is `lower_case`, whatever its case.
bool equalsIgnoringCase(std::string_view word, std::string_view lower_case);

}  // namespace lamina
