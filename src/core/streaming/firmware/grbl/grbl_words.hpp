// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace lamina {

/// A letter, in upper case, and its number.
struct GrblWord {
  char letter = ' ';
  double value = 0.0;

  /// Ten times the number of a command: 382 for G38.2.
  int tenfold() const { return static_cast<int>(std::lround(10.0 * value)); }
};

/// The words of a line of G-code as grbl reads them: blanks are ignored, letters may be in lower case.
class GrblWords {
 public:
  const GrblWord* begin() const { return words_.data(); }
  const GrblWord* end() const { return words_.data() + count_; }

  /// @return nothing if the line is no sequence of letters with numbers, or has more than 32 words
  static std::optional<GrblWords> of(std::string_view line);

 private:
  std::array<GrblWord, 32> words_{};
  std::size_t count_ = 0;
};

}  // namespace lamina
