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

/// The safe stop of firmware that has no command to end motions without losing the position: the firmware
/// runs what it has accepted. Heaters, fans, spindles and lasers are switched off first; the machine reports
/// that heaters are off.
class OkPacedStop {
 public:
  OkPacedStop(const StreamSettings& settings, std::shared_ptr<const OkPacedFirmware> firmware);

  /// Begins with the heaters, unless they are to stay on.
  void begin(double now);
  /// States that the machine can be reached again.
  void beginAgain(double now);
  /// Waits for the reason of a halt instead of stopping.
  void awaitReason() { stage_ = Stage::Reason; }
  bool isAwaitingReason() const { return stage_ == Stage::Reason; }
  /// Waits for the end of the motions, once the heaters are reported off.
  /// @return whether the wait begins
  bool awaitRest(double now);
  bool isAwaitingRest() const { return stage_ == Stage::Rest; }

  /// The commands to be sent at the present stage.
  std::vector<std::string> commands(const UsedOutputs& outputs) const;
  void sent() { are_heaters_off_.reset(); }

  /// Evaluates any report, with or without heaters.
  void hear(const PacedReply& reply);
  /// States that the machine still responds. A machine that waits for a temperature reads the stop only once
  /// the temperature is reached.
  /// @return what the user should know about the delay; empty if nothing
  std::string prolong(double now);

  double giveUpAt() const { return give_up_s_; }
  /// The command that stops the machine at once, if its time has come. The stop then waits for its effect.
  /// @return empty if the stop is to be given up instead
  std::string takeEmergencyStop(double now);
  /// What is not confirmed when the stop is given up, for the end of a message.
  std::string remark() const;

 private:
  enum class Stage : std::uint8_t { SwitchOff, Rest, Reason };

  /// The command that stops at once a machine that does not react to the stop; empty if there is none.
  std::string emergencyStop() const;

  StreamSettings settings_;
  std::shared_ptr<const OkPacedFirmware> firmware_;
  Stage stage_ = Stage::SwitchOff;
  bool is_emergency_ = false;            ///< whether an emergency stop was sent
  std::optional<bool> are_heaters_off_;  ///< as reported since the commands were sent last
  std::string temperatures_;             ///< the last temperature report
  double began_s_ = 0.0;
  double give_up_s_ = 0.0;  ///< time to give up, unless the machine still responds
  double latest_s_ = 0.0;   ///< time to give up in any case
};

}  // namespace lamina
