// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/plc_watch.hpp"
#include "lamina/modbus/modbus_frame.hpp"
#include "lamina/modbus/register_map.hpp"

namespace lamina {

/// Settings of the link to a PLC.
struct PlcLinkSettings {
  WordOrder word_order = WordOrder::HighFirst;
  double watchdog_s = 2.0;  ///< time without a change of the PLC's heartbeat after which the watchdog is lost
  double abandon_s = 300.0;  ///< time without a change of the heartbeat after which a held unit is stopped
};

/// Whether the PLC may give commands; only maintenance changes it.
enum class RemoteAccess : std::uint8_t { Locked, Allowed };

/// An order of the PLC, which is carried out once.
struct PlcOrder {
  enum class Kind : std::uint8_t { Command, Mode, Job, Acknowledge };
  Kind kind = Kind::Command;
  std::uint32_t value = 0;     ///< number of the command, mode, job or alarm
  std::uint16_t sequence = 0;  ///< sequence number that came with it; 0 for acknowledgements
};

/// Whether the cell reports the state of the unit.
enum class UnitPresence : std::uint8_t { Lost, Present };

/// The unit as seen by the PLC: answers requests from the registers, and finds orders in them. Requests and
/// times are passed in, answers and orders are returned; it has no network of its own.
///
/// A command is carried out once, when its sequence number changes to a value other than 0. If the first
/// value written to a sequence register is not 0, it may be left over from an earlier link: a command with it
/// is answered StaleSequence, and other orders are dropped; only a Stop, Hold or Abort that is written alone
/// is carried out. Only one connection may write: the first one that does, until it is closed or the watchdog
/// is lost. All others are answered ServerBusy, unless they write a Stop, Hold or Abort alone: this is
/// carried out, without changing the registers or the connection that may write. The same sequence is a new
/// Stop, Hold or Abort there once the connection has written another one or 0, also if that was refused.
class PlcLink {
 public:
  explicit PlcLink(const PlcLinkSettings& settings) : settings_(settings) {}

  /// The answer to a request, as bytes to be sent on the same connection.
  std::string answer(int connection, const ModbusRequest& request, double now_s);

  /// Reports that a connection was closed.
  void close(int connection);

  /// Sets whether the PLC may give commands.
  void setRemoteAccess(RemoteAccess access) { access_ = access; }
  /// Sets what the input registers report of the unit.
  void setStatus(const PlcStatus& status) { status_ = status; }

  /// Sets whether the unit is present; at first it is lost. While it is lost, Lamina's heartbeat stands
  /// still, commands other than Stop, Hold and Abort are answered Busy, and other orders are dropped.
  void setPresence(UnitPresence presence, double now_s);

  /// The orders since the last call, oldest first. While remote access is locked, the watchdog is lost or the
  /// unit is lost, only Stop, Hold and Abort are among them: other commands are answered with the reason, and
  /// other orders are dropped.
  std::vector<PlcOrder> takeOrders();

  /// Reports the result of a command to the PLC. For other orders nothing is reported, as the status shows
  /// their result.
  void setResult(const PlcOrder& order, CommandResult result);

  /// Checks the heartbeat of the PLC; to be called periodically. The watchdog is armed by the first change of
  /// the heartbeat while remote access is allowed.
  PlcHeartbeat watch(double now_s);

  /// Whether the watchdog is armed and good.
  bool isAlive() const { return watchdog_ == PlcHeartbeat::Good; }

  /// Whether the heartbeat comes: it has changed within `watchdog_s`, whether or not the watchdog is armed.
  bool isBeating(double now_s) const { return has_beaten_ && now_s - heard_s_ <= settings_.watchdog_s; }

  /// Number of changes in the PLC's reports on its surroundings: interlocks, plate, speed, badge.
  std::uint32_t news() const { return news_; }

  /// Whether the PLC has written the register of its plate; before that the register has no meaning.
  bool isPlateWritten() const;

  /// The values that the PLC has written.
  PlcInputs inputs() const { return plcInputs(holding_, settings_.word_order); }

  /// The input registers as the PLC reads them at a time.
  InputRegisters registers(double now_s) const;

 private:
  std::optional<ModbusException> write(int connection, const ModbusRequest& request, double now_s);
  void takeStop(int connection, const ModbusRequest& request);
  void forgetStop(int connection, const ModbusRequest& request);
  void findOrders(int connection, const ModbusRequest& request, const HoldingRegisters& before);
  void order(const PlcOrder& order);

  PlcLinkSettings settings_;
  RemoteAccess access_ = RemoteAccess::Locked;
  PlcStatus status_;
  UnitPresence presence_ = UnitPresence::Lost;
  double lost_s_ = 0.0;  ///< when the unit was lost
  LinkFigures figures_;
  HoldingRegisters holding_{};
  std::bitset<kHoldingRegisters> written_;  ///< which of them the PLC has written
  std::optional<int> writer_;
  std::map<int, std::uint16_t> stops_;  ///< last sequences of connections that stopped without writing
  PlcHeartbeat watchdog_ = PlcHeartbeat::Unarmed;
  bool has_beaten_ = false;
  double heard_s_ = 0.0;
  bool was_refused_ = false;
  std::uint32_t news_ = 0;
  std::vector<PlcOrder> orders_;
};

}  // namespace lamina
