// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/base/quotation.hpp"

namespace lamina {

/// A program file that is being read.
struct ReadFile {
  std::string name;
  Quotation quotation;  ///< what messages may quote of the file: nothing until it has proved to be a program
};

/// Reads a line of a program. Words are compared without regard to case, and white space between them is
/// skipped. All functions throw InvalidProgram, naming file, line, what was found and what was expected.
class LineCursor {
 public:
  /// @param file  for errors; must outlive the cursor
  LineCursor(std::string_view text, std::size_t line, const ReadFile& file)
      : rest_(text), line_(line), file_(&file) {}

  std::size_t line() const { return line_; }
  const ReadFile& file() const { return *file_; }
  bool isAtEnd();
  std::string_view rest() const { return rest_; }

  /// Reads past a text if it comes next, and returns whether it does. A word must end where the text ends.
  bool take(std::string_view text);
  /// Reads past a text.
  /// @throws InvalidProgram if it does not come next
  void expect(std::string_view text);
  /// Reads a word of letters, digits and underscores that does not begin with a digit.
  std::string word(const char* expected);
  /// Reads a number within bounds, both included.
  double number(double low, double high, const char* expected);
  int integer(int low, int high, const char* expected);
  void expectEnd();

  [[noreturn]] void refuse(const std::string& expected) const;
  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const;

 private:
  void skipSpace();

  std::string_view rest_;
  std::size_t line_;
  const ReadFile* file_;
};

/// The lines of a text, without carriage returns at their ends.
std::vector<std::string_view> textLines(std::string_view text);

}  // namespace lamina
