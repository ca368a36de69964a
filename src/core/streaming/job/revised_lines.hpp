// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/streaming/job/program_revision.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/line_feed.hpp"
#include "streaming/job/motion_time.hpp"

namespace lamina {

/// The commands of a text that is given in pieces of whole lines.
class GrowingCommands {
 public:
  GrowingCommands();

  /// Adds lines; to be called when `next` has given all commands.
  void give(std::string_view lines);
  /// The next command; nothing until more is given.
  std::optional<ProgramLine> next();
  /// The layer of the next command.
  std::int32_t layer() const { return cursor_.layer(); }

 private:
  std::stringstream* text_;  ///< of the cursor
  ProgramCursor cursor_;
};

/// The revised lines of a program. At the beginning of a layer the next line is not known until the revision
/// of the layer is decided; another program may then replace the rest. The lines end early if the program's
/// file was changed or its disk does not answer (`readAhead`), and with a failure if a line cannot be
/// revised.
class RevisedLines {
 public:
  /// @param defectOf  returns what the firmware would misread in a command, in words; empty if nothing
  RevisedLines(const StreamableProgram& program, std::shared_ptr<ProgramRevision> revision,
               std::function<std::string(const std::string&)> defectOf);

  /// Whether `next` may be called.
  bool isNextKnown();
  /// The next line; nothing at the end.
  std::optional<ProgramLine> next();

  /// Decides the layer that is waited for, once the longest wait is over.
  void decide();
  double waitTime() const { return revision_->waitTime(); }

  /// Number of commands of the whole program: those returned so far, and those not yet read.
  std::uint64_t total() const { return given_ + program_.lines() - read_; }
  /// Why a line could not be revised; Ok if each could.
  const Failure& failure() const { return failure_; }

 private:
  void readOn();
  void readLine();
  void goOnWith(const StreamableProgram& successor);
  void end(const Failure& why);

  StreamableProgram program_;
  std::shared_ptr<ProgramRevision> revision_;
  std::function<std::string(const std::string&)> defectOf_;
  LineFeed::Source text_;     ///< lines of the text as they are
  std::uint64_t number_ = 0;  ///< number of lines of the text that were read
  GrowingCommands planned_;
  GrowingCommands revised_;
  std::uint64_t read_ = 0;   ///< number of commands read of the program, or of the one that replaced it
  std::uint64_t given_ = 0;  ///< number of commands returned
  MotionTime time_;
  std::optional<ProgramLine> line_;  ///< the next one
  std::optional<std::int32_t> awaited_;
  std::int32_t layer_ = -1;
  bool is_over_ = false;
  Failure failure_;
};

class FirmwareProtocol;
struct StreamOrder;

/// The revised lines of an order's program, for a firmware; null if the lines are sent unchanged.
std::shared_ptr<RevisedLines> revisedLines(const StreamOrder& order,
                                           const std::shared_ptr<const FirmwareProtocol>& firmware);

/// The lines of a program, revised unless `revised` is null, and whether the next one is known.
LineFeed::Source sourceOf(const StreamableProgram& program, const std::shared_ptr<RevisedLines>& revised);
LineFeed::Readiness readinessOf(const std::shared_ptr<RevisedLines>& revised);

}  // namespace lamina
