// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Changes the lines of a program layer by layer, before they are numbered and sent. Called by one job, from
/// its thread.
class ProgramRevision {
 public:
  virtual ~ProgramRevision() = default;

  /// Whether the revision of a layer is decided. A decision is final.
  /// @param layer  as the program counts it
  virtual bool isKnown(std::int32_t layer) = 0;
  /// Decides a layer by what is known now, after the longest wait.
  virtual void decide(std::int32_t layer) = 0;
  /// A program that replaces the rest of this one, before a layer that is not decided; none if there is none.
  /// Once it is given, the revision is that of the new program: lines and layers count from its beginning.
  virtual std::optional<StreamableProgram> successor(std::int32_t /*layer*/) { return std::nullopt; }
  /// The record from which all lines given so far can be made again; none if it is not kept, or not for every
  /// line.
  virtual std::optional<RevisionRecord> record() const { return std::nullopt; }
  /// Why the record is no longer kept; empty if it is.
  virtual std::string recordFailure() const { return {}; }

  /// Longest time for which the machine waits at rest for a layer [s].
  virtual double waitTime() const = 0;

  /// The lines that replace a line of the program's text, separated by line feeds. Calls come in the order of
  /// lines, those of a layer once it is decided.
  /// @param number  of the line in the text, from 1
  /// @throws InvalidProgram if it cannot be changed
  virtual std::string revised(std::string_view line, std::uint64_t number) = 0;
};

}  // namespace lamina
