// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// The number of a line "N<number> ...", even if the rest of the line is invalid.
std::optional<std::uint64_t> lineNumberOf(std::string_view line);

/// The line after its backspaces, each of which erases the character before it.
std::string withoutErased(std::string_view line);

/// A received line as firmware reads it.
struct GatedLine {
  std::string refusal;  ///< why the line is refused; empty if it is accepted
  std::string command;  ///< the line without number and checksum
  std::optional<std::uint64_t> number;
};

/// Accepts lines as Marlin does. A numbered line must have the next number and the right checksum, or set the
/// number by M110. A line without number is accepted unless it has a checksum, which shows that its number
/// was lost.
class LineGate {
 public:
  GatedLine take(std::string_view line);
  std::uint64_t lastNumber() const { return last_number_; }
  /// The number that the last M110 has set.
  std::uint64_t firstNumber() const { return first_number_; }
  void reset() { last_number_ = first_number_ = 0; }

 private:
  std::uint64_t last_number_ = 0;
  std::uint64_t first_number_ = 0;
};

}  // namespace lamina
