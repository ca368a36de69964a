// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// Reads a mesh file in text word by word. Lines are counted only if an error message needs the number.
class TextCursor {
 public:
  TextCursor(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word, on any line; empty at the end.
  std::string_view word();
  /// The next word on this line; empty at its end, which is not passed.
  std::string_view wordInLine();
  void skipLine();
  bool isAtEnd() const { return position_ >= text_.size(); }
  std::size_t position() const { return position_; }

  /// The next word, on any line, as a finite number.
  double number();
  /// The next word on this line, as a finite number.
  double numberInLine();

  /// States that the file has proved to be a mesh, so that messages may quote it.
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

/// Whether a word equals `lower_case` if case is ignored.
bool equalsIgnoringCase(std::string_view word, std::string_view lower_case);

}  // namespace lamina
