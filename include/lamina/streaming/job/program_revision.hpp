// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lamina {

/// Changes a program on its way to a machine, layer by layer, before its lines are numbered: what was sent
/// is never changed. Called by one job, from its thread.
class ProgramRevision {
 public:
  virtual ~ProgramRevision() = default;

  /// Whether it is known what becomes of a layer. From then on it stays at that.
  /// @param layer  as the program counts it
  virtual bool isKnown(std::int32_t layer) = 0;
  /// The layer was waited for long enough: it is decided by what is known now.
  virtual void decide(std::int32_t layer) = 0;
  /// How long the machine, at rest, waits for a layer [s].
  virtual double waitTime() const = 0;

  /// The lines that a line of the program's text becomes, with line feeds between them; lines are given in
  /// order, those of a layer once it is known.
  /// @param number  of the line in the text, from 1
  /// @throws InvalidProgram if it cannot be changed
  virtual std::string revised(std::string_view line, std::uint64_t number) = 0;
};

}  // namespace lamina
