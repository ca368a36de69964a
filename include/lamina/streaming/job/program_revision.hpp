// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/job/streamable_program.hpp"

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
  /// A program that takes the place of what is left, in front of a layer that is not known yet; nothing while
  /// it goes on. Once it is given the revision is of that one: lines and layers count from its beginning.
  virtual std::optional<StreamableProgram> successor(std::int32_t /*layer*/) { return std::nullopt; }
  /// The record from which the lines that were given can be made again, as far as they were; nothing where
  /// none is kept, or not for every line.
  virtual std::optional<RevisionRecord> record() const { return std::nullopt; }
  /// Why it is kept no more; empty while all is well.
  virtual std::string recordFailure() const { return {}; }

  /// How long the machine, at rest, waits for a layer [s].
  virtual double waitTime() const = 0;

  /// The lines that a line of the program's text becomes, with line feeds between them; lines are given in
  /// order, those of a layer once it is known.
  /// @param number  of the line in the text, from 1
  /// @throws InvalidProgram if it cannot be changed
  virtual std::string revised(std::string_view line, std::uint64_t number) = 0;
};

}  // namespace lamina
