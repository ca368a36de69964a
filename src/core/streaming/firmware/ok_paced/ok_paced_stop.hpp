// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"
#include "streaming/job/used_outputs.hpp"

namespace lamina {

/// The safe stop of firmware that has no command by which motions end without losing the position: it runs
/// what it has taken. All that heats or turns is switched off first, which the machine reports.
class OkPacedStop {
 public:
  OkPacedStop(const StreamSettings& settings, std::shared_ptr<const OkPacedFirmware> firmware);

  /// Begins with the heaters, unless they are to stay on.
  void begin(double now);
  /// States that the machine can be reached again.
  void beginAgain(double now);
  /// Waits for the reason of a halt instead.
  void awaitReason() { stage_ = Stage::Reason; }
  bool isAwaitingReason() const { return stage_ == Stage::Reason; }
  /// Waits for the end of the motions, once the heaters are reported off.
  /// @return whether the wait begins
  bool awaitRest(double now);
  bool isAwaitingRest() const { return stage_ == Stage::Rest; }

  /// The commands to send, now or if the stop began now.
  std::vector<std::string> commands(const UsedOutputs& outputs) const;
  void sent() { are_heaters_off_.reset(); }

  /// Takes any report, with or without heaters.
  void hear(const PacedReply& reply);
  /// States that the machine shows that it lives: one that waits for heat hears the stop once the heat is
  /// there.
  /// @return what a person should know of the delay; empty if nothing
  std::string prolong(double now);

  double giveUpAt() const { return give_up_s_; }
  /// The command that stops the machine at once, if it is to be sent when that time has come. Its effect is
  /// waited for.
  /// @return empty if it is to be given up instead
  std::string takeEmergencyStop(double now);
  /// What is not confirmed then, for the end of a message.
  std::string remark() const;

 private:
  enum class Stage : std::uint8_t { SwitchOff, Rest, Reason };

  /// The command that would stop at once a machine that does not hear the stop; empty if there is none.
  std::string emergencyStop() const;

  StreamSettings settings_;
  std::shared_ptr<const OkPacedFirmware> firmware_;
  Stage stage_ = Stage::SwitchOff;
  bool is_emergency_ = false;            ///< an emergency stop was sent
  std::optional<bool> are_heaters_off_;  ///< since the commands were sent last
  std::string temperatures_;             ///< the last report of these
  double began_s_ = 0.0;
  double give_up_s_ = 0.0;  ///< unless the machine shows that it lives
  double latest_s_ = 0.0;   ///< in any case
};

}  // namespace lamina
