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

/// The progress of a job of an earlier session that is to be resumed, in lines of the program, from 1.
struct UnfinishedLines {
  std::uint64_t taken_through = 0;  ///< acknowledged
  std::uint64_t sent_through = 0;   ///< no line after it was ever sent
  std::string firmware_name;        ///< as the machine gave it, empty if it gave none
};

/// A program to be streamed, and what is known of the machine.
struct StreamOrder {
  StreamableProgram program;
  StreamSettings settings;
  ReplyListener heard;                       ///< may be empty
  std::optional<std::string> firmware_name;  ///< as the machine gave it, empty if it gave none; nothing if it
                                             ///< was not asked yet
  std::uint64_t line_base =
      0;  ///< firmware that counts lines counts from here, so that it knows the job again
  std::optional<UnfinishedLines> unfinished;  ///< nothing for a job that begins
  int answers_due = 0;                        ///< answers to repeated questions that may still arrive
  std::shared_ptr<ProgramRevision> revision = nullptr;  ///< null if the lines are sent unchanged
};

/// The protocol of a family of firmware, as `Streamer` uses it. Constant, and called from several threads at
/// once.
class FirmwareProtocol {
 public:
  virtual ~FirmwareProtocol() = default;

  /// Whether a firmware of that name, as it answers to `M115` or greets, speaks this protocol.
  virtual bool isSpokenBy(std::string_view firmware_name) const = 0;

  /// What this firmware would misread in a command (as `ProgramCursor` gives it), as the end of a sentence:
  /// "has a '*', which marks a checksum". Empty if it takes the command, even one that is unknown to it.
  /// @param settings  `max_line_bytes` of 0 stands for the firmware's usual limit
  virtual std::string defectOf(std::string_view command, const StreamSettings& settings) const = 0;

  /// Whether the job of an earlier session can be resumed on a machine that was not reset since.
  virtual bool canResume() const { return false; }
  /// Whether the lines of a program can be revised before they are sent.
  virtual bool canRevise() const { return false; }

  /// A job in Idle. It identifies the machine before it sends anything else, unless the order states the
  /// firmware.
  /// @throws InvalidConfig if the settings do not suit the firmware
  virtual std::unique_ptr<StreamJob> begin(StreamOrder order) const = 0;
};

/// All protocols by name, those of plug-ins too. One is added by `firmwareProtocols().add("name",
/// std::make_shared<...>())`; the pointer must not be null.
Registry<std::shared_ptr<const FirmwareProtocol>>& firmwareProtocols();

}  // namespace lamina
