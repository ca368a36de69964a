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

/// What an earlier session left behind, whose job is gone on with. Lines of the program, from 1.
struct UnfinishedLines {
  std::uint64_t taken_through = 0;  ///< acknowledged
  std::uint64_t sent_through = 0;   ///< no line beyond has ever left
  std::string firmware_name;        ///< as the machine gave it, empty if it gave none
};

/// What is to be streamed, and what is known of the machine.
struct StreamOrder {
  StreamableProgram program;
  StreamSettings settings;
  ReplyListener heard;                       ///< may be empty
  std::optional<std::string> firmware_name;  ///< as the machine gave it, empty if it gave none; nothing if it
                                             ///< was not asked yet
  std::uint64_t line_base =
      0;  ///< firmware that counts lines counts from here, so that it knows the job again
  std::optional<UnfinishedLines> unfinished;  ///< nothing for a job that begins
  int answers_due = 0;                        ///< to questions put more than once, which may still come
  std::shared_ptr<ProgramRevision> revision = nullptr;  ///< null if the lines go as they are
};

/// How a family of firmware is spoken to: the port through which `Streamer` reaches it. Constant, and called
/// from several threads at once.
class FirmwareProtocol {
 public:
  virtual ~FirmwareProtocol() = default;

  /// Whether a firmware of that name, as it answers to `M115` or greets, speaks this protocol.
  virtual bool isSpokenBy(std::string_view firmware_name) const = 0;

  /// What this firmware would misread of a command as `ProgramCursor` gives it, as the end of a sentence:
  /// "has a '*', which marks a checksum". Empty if it takes the command, be it that it does not know it.
  /// @param settings  `max_line_bytes` of 0 stands for the firmware's usual limit
  virtual std::string defectOf(std::string_view command, const StreamSettings& settings) const = 0;

  /// Whether a job can go on where an earlier session left it, on a machine that has lived on.
  virtual bool canResume() const { return false; }
  /// Whether the lines of a program can be revised on their way.
  virtual bool canRevise() const { return false; }

  /// A job in Idle, which asks who is there before it sends anything else, unless the order says so.
  /// @throws InvalidConfig where the settings do not suit the firmware
  virtual std::unique_ptr<StreamJob> begin(StreamOrder order) const = 0;
};

/// All protocols, those of plug-ins too. Whoever adds one calls
/// `firmwareProtocols().add("name", std::make_shared<...>())`; null pointers are not for use.
Registry<std::shared_ptr<const FirmwareProtocol>>& firmwareProtocols();

}  // namespace lamina
