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

/// The answer to a numbered question, which cannot be mistaken for that to another one.
struct SyncAnswer {
  std::uint64_t question = 0;
  std::optional<ReportedPosition> position;  ///< of the last motion taken, if it was asked for
};

/// One line of the firmware.
struct PacedReply {
  FirmwareReply reply;
  bool is_refusal = false;                ///< the command under way was not run, or not to its end
  std::optional<bool> are_heaters_off;    ///< none if the line does not state it
  std::optional<SyncAnswer> sync_answer;  ///< none if the line is no such answer
};

/// The meaning of the firmware's answer to a question of the opening.
struct OpeningVerdict {
  enum class Kind : std::uint8_t {
    Suits,
    NotYet,  ///< to be asked again
    Refused,
  };
  Kind kind = Kind::Suits;
  std::string why;  ///< unless it suits
};

/// The protocol of firmware that answers each line by one `ok`, in order, and requests none again.
/// `OkPacedJob` is common to all such firmware; the differences are here. Commands are lines without number
/// and end of line.
class OkPacedFirmware : public FirmwareProtocol, public std::enable_shared_from_this<OkPacedFirmware> {
 public:
  bool canRevise() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;

  /// A command as it is sent, with its end of line.
  virtual std::string framed(std::uint64_t number, std::string_view command) const = 0;
  /// Parses a line of the firmware. Any line is accepted; an unknown one is Information.
  virtual PacedReply read(std::string_view line) const = 0;

  /// The questions to be answered before the first line, in order.
  virtual std::vector<std::string> opening(LinkKind link) const = 0;
  /// Judges the answer to a question of the opening.
  /// @param lines  of the firmware after that question, up to its ok
  virtual OpeningVerdict judge(const std::string& question, const std::vector<std::string>& lines) const = 0;

  /// A harmless command that makes the firmware send this number, and on a lossy link its position.
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
  /// @param temperatures  the last report of these, which names the tools; may be empty
  virtual std::vector<std::string> switchOff(const std::string& temperatures) const = 0;
  /// A command that halts the machine at once, whatever it waits for; empty if there is none.
  virtual std::string emergencyStop() const { return {}; }
  /// Most commands without an answer with which the firmware still reads `emergencyStop`.
  virtual std::size_t mostUnanswered() const { return std::numeric_limits<std::size_t>::max(); }
  /// Message on the state of a machine that has halted by itself.
  virtual std::string afterHalt() const = 0;
  /// The question of the opening whose answer states why it has halted; empty if there is none.
  virtual std::string reasonOfHalt() const = 0;
  /// Message on the state of a machine that has restarted; empty if it takes commands.
  virtual std::string afterRestart() const = 0;
};

}  // namespace lamina
