// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Interface that changes the lines of a program, layer by layer, before they are numbered and sent, for
/// example to correct them after a scan. It serves one job and is called from the thread of that job.
class ProgramRevision {
 public:
  virtual ~ProgramRevision() = default;

  /// Whether the revision of a layer is decided. A decision is final.
  /// @param layer  number of the layer in the program
  virtual bool isKnown(std::int32_t layer) = 0;
  /// Decides the revision of a layer from what is known at present; called after the longest wait.
  virtual void decide(std::int32_t layer) = 0;
  /// A program that replaces the present one from an undecided layer on; nothing if the present one
  /// continues. After its return this object revises the new program: all later calls refer to the new lines
  /// and layers.
  virtual std::optional<StreamableProgram> successor(std::int32_t /*layer*/) { return std::nullopt; }
  /// The record from which all lines returned so far can be made again; nothing if there is none, or it does
  /// not cover every line.
  virtual std::optional<RevisionRecord> record() const { return std::nullopt; }
  /// The reason why the record is no longer kept; empty if it is kept.
  virtual std::string recordFailure() const { return {}; }

  /// Longest time for which the machine waits, at rest, for the decision on a layer [s].
  virtual double waitTime() const = 0;

  /// The lines that replace a line of the program's text, separated by line feeds. It is called for the lines
  /// in their order, and for the lines of a layer only once the layer is decided.
  /// @param number  number of the line in the text, from 1
  /// @throws InvalidProgram if the line cannot be changed
  virtual std::string revised(std::string_view line, std::uint64_t number) = 0;
};

}  // namespace lamina
