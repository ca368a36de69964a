// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// The number of a line "N<number> ...", whether the rest of it is right or not.
std::optional<std::uint64_t> lineNumberOf(std::string_view line);

/// A line as it was meant by who sent backspaces, each of which takes away the character before it.
std::string withoutErased(std::string_view line);

/// What firmware makes of a received line.
struct GatedLine {
  std::string refusal;  ///< why it is not taken; empty if it is
  std::string command;  ///< without number and checksum
  std::optional<std::uint64_t> number;
};

/// Takes lines as Marlin does: a numbered line must carry the number after the last one and the right
/// checksum, or set the number by M110; a line without number is taken unless it has a checksum, which
/// betrays a lost number.
class LineGate {
 public:
  GatedLine take(std::string_view line);
  std::uint64_t lastNumber() const { return last_number_; }
  /// Where lines count from, as the last M110 has set it.
  std::uint64_t firstNumber() const { return first_number_; }
  void reset() { last_number_ = first_number_ = 0; }

 private:
  std::uint64_t last_number_ = 0;
  std::uint64_t first_number_ = 0;
};

}  // namespace lamina
