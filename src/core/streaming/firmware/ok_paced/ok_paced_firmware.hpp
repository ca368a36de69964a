// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/streaming/job/firmware_protocol.hpp"
#include "streaming/job/change_commands.hpp"

namespace lamina {

/// The answer to a numbered question. The number shows which question it answers.
struct SyncAnswer {
  std::uint64_t question = 0;
  std::optional<ReportedPosition> position;  ///< end of the last motion accepted, if the question asks for it
};

/// One line of the firmware.
struct PacedReply {
  FirmwareReply reply;
  bool is_refusal = false;                ///< whether the current command was not run, or not to its end
  std::optional<bool> are_heaters_off;    ///< nothing if the line does not state it
  std::optional<SyncAnswer> sync_answer;  ///< nothing if the line is no such answer
};

/// The meaning of the firmware's answer to a question of the opening.
struct OpeningVerdict {
  enum class Kind : std::uint8_t {
    Suits,
    NotYet,  ///< to be asked again
    Refused,
  };
  Kind kind = Kind::Suits;
  std::string why;  ///< reason, unless Kind is Suits
};

/// The protocol of firmware that answers each line by one `ok`, in order, and never requests a line again.
/// `OkPacedJob` streams to all such firmware; this class holds the differences. Commands have no number and
/// no end of line.
class OkPacedFirmware : public FirmwareProtocol, public std::enable_shared_from_this<OkPacedFirmware> {
 public:
  bool canRevise() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;

  /// A command as it is sent, with its end of line.
  virtual std::string framed(std::uint64_t number, std::string_view command) const = 0;
  /// Parses a line from the firmware. Every line is accepted; one of unknown kind is Information.
  virtual PacedReply read(std::string_view line) const = 0;

  /// Questions to be answered before the first line, in order.
  virtual std::vector<std::string> opening(LinkKind link) const = 0;
  /// Judges the answer to a question of the opening.
  /// @param lines  of the firmware after the question, up to the ok
  virtual OpeningVerdict judge(const std::string& question, const std::vector<std::string>& lines) const = 0;

  /// A harmless command that makes the firmware send this number and, on a lossy link, its position.
  virtual std::string question(std::uint64_t number, LinkKind link) const = 0;
  /// Whether the firmware may be silent for long while it runs a command.
  virtual bool isBlocking(std::string_view command) const = 0;
  /// Whether the firmware refuses damaged lines, so that a lossy link may be used.
  virtual bool detectsDamage() const = 0;

  /// The command for a change of the running job.
  virtual ChangeCommand changed(const LiveChange& change, const StreamableProgram& program) const = 0;

  /// The command that ends a pause which the machine has begun by itself; empty if it needs none.
  virtual std::string resumption() const { return {}; }

  /// Commands that switch off all that heats or turns.
  /// @param temperatures  the last temperature report, which names the tools; may be empty
  virtual std::vector<std::string> switchOff(const std::string& temperatures) const = 0;
  /// A command that halts the machine at once, even while it waits; empty if there is none.
  virtual std::string emergencyStop() const { return {}; }
  /// Greatest number of unanswered commands with which the firmware still reads `emergencyStop`.
  virtual std::size_t mostUnanswered() const { return std::numeric_limits<std::size_t>::max(); }
  /// Message on the state of a machine that has halted by itself.
  virtual std::string afterHalt() const = 0;
  /// The opening question whose answer states why the machine has halted; empty if there is none.
  virtual std::string reasonOfHalt() const = 0;
  /// Message on the state of a machine that has restarted; empty if it accepts commands.
  virtual std::string afterRestart() const = 0;
};

}  // namespace lamina
