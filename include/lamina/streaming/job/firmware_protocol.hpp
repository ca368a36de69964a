// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/base/registry.hpp"
#include "lamina/streaming/job/program_revision.hpp"
#include "lamina/streaming/job/stream_job.hpp"
#include "lamina/streaming/job/stream_settings.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// The progress of a job that an earlier session left unfinished and that is to be resumed. Line numbers
/// count the program's lines with a command, from 1; 0 for none.
struct UnfinishedLines {
  std::uint64_t taken_through = 0;  ///< last line that was acknowledged
  std::uint64_t sent_through = 0;   ///< no line after this one was ever sent
  std::string firmware_name;        ///< name that the machine has given; empty if it gave none
};

/// A program to be streamed, and what is known of the machine.
struct StreamOrder {
  StreamableProgram program;
  StreamSettings settings;
  ReplyListener heard;  ///< may be empty
  /// Name that the machine has given, empty if it gave none; nothing if it was not asked yet.
  std::optional<std::string> firmware_name;
  /// Number of the line before the program's first, for firmware that numbers lines; it identifies a resumed
  /// job.
  std::uint64_t line_base = 0;
  std::optional<UnfinishedLines> unfinished;  ///< nothing for a job that begins at its first line
  int answers_due = 0;  ///< number of answers that may still arrive, as a question was sent repeatedly
  std::shared_ptr<ProgramRevision> revision = nullptr;  ///< null if the lines are sent unchanged
  bool hears_at_once = false;  ///< whether the machine has said that it hears `M108` while it waits
};
/// Interface of a protocol, which a family of firmware speaks; `Streamer` uses it. Implementations have no
/// mutable state, since several threads call them at once.
class FirmwareProtocol {
 public:
  virtual ~FirmwareProtocol() = default;

  /// Whether firmware of this name, from its answer to `M115` or its greeting, speaks this protocol.
  virtual bool isSpokenBy(std::string_view firmware_name) const = 0;

  /// The reason why this firmware would misread a command (as `ProgramCursor` gives it), as the predicate of
  /// a sentence: "has a '*', which marks a checksum". Empty if it reads the command correctly, even if it
  /// does not know it.
  /// @param settings  `max_line_bytes` of 0 stands for the firmware's usual limit
  virtual std::string defectOf(std::string_view command, const StreamSettings& settings) const = 0;

  /// Whether the job of an earlier session can be resumed on a machine that was not reset in between.
  virtual bool canResume() const { return false; }
  /// Whether the lines of a program can be revised before they are sent.
  virtual bool canRevise() const { return false; }

  /// Makes a job in the state Idle. It identifies the machine before it sends anything else, unless the order
  /// has a `firmware_name`.
  /// @throws InvalidConfig if the settings do not suit the firmware
  virtual std::unique_ptr<StreamJob> begin(StreamOrder order) const = 0;
};

/// The registry of all protocols by name, those of plug-ins included. A protocol is added by
/// `firmwareProtocols().add("name", std::make_shared<...>())`; the pointer must not be null.
Registry<std::shared_ptr<const FirmwareProtocol>>& firmwareProtocols();

}  // namespace lamina
