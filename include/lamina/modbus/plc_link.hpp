// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/plc_watch.hpp"
#include "lamina/modbus/modbus_frame.hpp"
#include "lamina/modbus/register_map.hpp"

namespace lamina {

struct PlcLinkSettings {
  WordOrder word_order = WordOrder::HighFirst;
  double watchdog_s = 2.0;   ///< without a change of the heartbeat
  double abandon_s = 300.0;  ///< of silence after which a held unit is stopped
};

/// Who may command: only maintenance changes it.
enum class RemoteAccess : std::uint8_t { Locked, Allowed };

/// What the PLC asks for, once.
struct PlcOrder {
  enum class Kind : std::uint8_t { Command, Mode, Job, Acknowledge };
  Kind kind = Kind::Command;
  std::uint32_t value = 0;  ///< command, mode, job or alarm, by number
  std::uint16_t sequence = 0;
};

/// Whether the cell reports the state of the unit.
enum class UnitPresence : std::uint8_t { Lost, Present };

/// The unit as the PLC sees it: answers requests from the registers, and finds orders in them. Takes requests
/// and times, gives answers and orders; no network.
///
/// A command is taken once, when its sequence changes to a value other than 0. One connection writes: the
/// first that does, until it is closed or the watchdog is lost; others are answered ServerBusy, but for Stop,
/// Hold and Abort.
class PlcLink {
 public:
  explicit PlcLink(const PlcLinkSettings& settings) : settings_(settings) {}

  /// The answer to a request: bytes for the connection it came on.
  std::string answer(int connection, const ModbusRequest& request, double now_s);

  /// A connection was closed.
  void close(int connection);

  void setRemoteAccess(RemoteAccess access) { access_ = access; }
  void setStatus(const PlcStatus& status) { status_ = status; }

  /// While the unit is lost, as it is at first, Lamina's heartbeat stands still and commands other than Stop,
  /// Hold and Abort are answered Busy.
  void setPresence(UnitPresence presence, double now_s);

  /// The orders since the last call, oldest first. Commands that cannot be followed were answered and are not
  /// among them. While remote access is locked or the watchdog is lost, these are all commands except Stop,
  /// Hold and Abort.
  std::vector<PlcOrder> takeOrders();

  /// Reports to the PLC what became of a command. What became of other orders is seen in the status.
  void setResult(const PlcOrder& order, CommandResult result);

  /// Looks at the heartbeat. The watchdog is armed by the first change of the heartbeat while remote access
  /// is allowed.
  PlcHeartbeat watch(double now_s);

  bool isAlive() const { return watchdog_ == PlcHeartbeat::Good; }

  /// Number of times that the PLC has reported a change of its surroundings: interlocks, plate, speed, badge.
  std::uint32_t news() const { return news_; }

  /// True once the PLC has written the register of its plate; until then the content of the register means
  /// nothing.
  bool isPlateWritten() const { return is_plate_written_; }

  /// As written last.
  PlcInputs inputs() const { return plcInputs(holding_, settings_.word_order); }

  /// As read by the PLC at that time.
  InputRegisters registers(double now_s) const;

 private:
  std::optional<ModbusException> write(int connection, const ModbusRequest& request, double now_s);
  void findOrders(const PlcInputs& before);
  void order(const PlcOrder& order);

  PlcLinkSettings settings_;
  RemoteAccess access_ = RemoteAccess::Locked;
  PlcStatus status_;
  UnitPresence presence_ = UnitPresence::Lost;
  double lost_s_ = 0.0;  ///< when the unit was lost
  LinkFigures figures_;
  HoldingRegisters holding_{};
  std::optional<int> writer_;
  PlcHeartbeat watchdog_ = PlcHeartbeat::Unarmed;
  double heard_s_ = 0.0;
  bool was_refused_ = false;
  bool is_plate_written_ = false;
  std::uint32_t news_ = 0;
  std::vector<PlcOrder> orders_;
};

}  // namespace lamina
