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

/// The answer to a question that carries an identity, so that it cannot be taken for that of another.
struct SyncAnswer {
  std::uint64_t question = 0;
  std::optional<ReportedPosition> position;  ///< of the last motion taken, if it was asked for
};

/// One line of the firmware.
struct PacedReply {
  FirmwareReply reply;
  bool is_refusal = false;                ///< the command under way was not run, or not to its end
  std::optional<bool> are_heaters_off;    ///< nothing if the line does not tell
  std::optional<SyncAnswer> sync_answer;  ///< nothing if the line is none
};

/// What the firmware's answer to a question of the opening means.
struct OpeningVerdict {
  enum class Kind : std::uint8_t {
    Suits,
    NotYet,  ///< to be asked again
    Refused,
  };
  Kind kind = Kind::Suits;
  std::string why;  ///< unless it suits
};

/// Firmware that answers each line it reads by one `ok`, in order, and asks for none again. What is common to
/// such firmware is the job (`OkPacedJob`); what differs is here. Commands are lines without number and end.
class OkPacedFirmware : public FirmwareProtocol, public std::enable_shared_from_this<OkPacedFirmware> {
 public:
  bool canRevise() const override { return true; }
  std::unique_ptr<StreamJob> begin(StreamOrder order) const override;

  /// A command as it goes out, with its end of line.
  virtual std::string framed(std::uint64_t number, std::string_view command) const = 0;
  /// What a line of the firmware means. Nothing is refused: an unknown line is Information.
  virtual PacedReply read(std::string_view line) const = 0;

  /// The questions to be answered before the first line, in order.
  virtual std::vector<std::string> opening(LinkKind link) const = 0;
  /// @param lines  what the firmware has said to that question, up to its ok
  virtual OpeningVerdict judge(const std::string& question, const std::vector<std::string>& lines) const = 0;

  /// A harmless command that makes the firmware say this number; on a lossy link its position too.
  virtual std::string question(std::uint64_t number, LinkKind link) const = 0;
  /// Whether the firmware may say nothing for long while it runs a command.
  virtual bool isBlocking(std::string_view command) const = 0;
  /// Whether the firmware refuses damaged lines, so that it may be spoken to over a lossy link.
  virtual bool detectsDamage() const = 0;

  /// Changes how it prints.
  virtual ChangeCommand changed(const LiveChange& change, const StreamableProgram& program) const = 0;

  /// Turns off what heats or turns.
  /// @param temperatures  the last report of these, which names the tools; may be empty
  virtual std::vector<std::string> switchOff(const std::string& temperatures) const = 0;
  /// A command that halts the machine at once, whatever it waits for; empty if there is none.
  virtual std::string emergencyStop() const { return {}; }
  /// How many commands may wait for their answers so that it still hears that one.
  virtual std::size_t mostUnanswered() const { return std::numeric_limits<std::size_t>::max(); }
  /// What is known of a machine that has halted by itself.
  virtual std::string afterHalt() const = 0;
  /// The question of the opening that tells why it has halted; empty if there is none.
  virtual std::string reasonOfHalt() const = 0;
  /// What is known of a machine that starts anew; empty if it takes commands.
  virtual std::string afterRestart() const = 0;
};

}  // namespace lamina
