// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/plc_link.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr double kHeartbeatInterval = 0.5;  // [s]
constexpr std::size_t kHeartbeatRegister = 0;
constexpr std::size_t kCommandRegister = 1;
constexpr std::size_t kCommandSequenceRegister = 2;
constexpr std::size_t kModeSequenceRegister = 4;
constexpr std::size_t kJobSequenceRegister = 7;
constexpr std::size_t kPlateRegister = 11;
constexpr std::size_t kAcknowledgedRegister = 14;

bool isStopping(std::uint32_t command) {
  const auto known = unitCommand(static_cast<int>(std::min<std::uint32_t>(command, 1000)));
  return known && precedence(*known) <= precedence(UnitCommand::Hold);
}

template <std::size_t kCount>
std::vector<std::uint16_t> slice(const std::array<std::uint16_t, kCount>& registers, std::size_t at,
                                 std::size_t count) {
  const auto first = registers.begin() + static_cast<std::ptrdiff_t>(at);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

/// What is neither heartbeat nor asked for: interlocks to speed, and the badge.
std::vector<std::uint16_t> surroundings(const HoldingRegisters& registers) {
  std::vector<std::uint16_t> values = slice(registers, 8, 6);
  const std::vector<std::uint16_t> badge = slice(registers, 20, 16);
  values.insert(values.end(), badge.begin(), badge.end());
  return values;
}

/// A request that writes command and sequence, no more, and whose command stops.
bool isStopAlone(const ModbusRequest& request) {
  return request.write_address == kCommandRegister && request.written.size() == 2 &&
         isStopping(request.written[0]);
}

/// What a request writes into a register; nothing if it leaves it.
std::optional<std::uint16_t> writtenTo(std::size_t address, const ModbusRequest& request) {
  if (address < request.write_address || address - request.write_address >= request.written.size())
    return std::nullopt;
  return request.written[address - request.write_address];
}

}  // namespace

std::string PlcLink::answer(int connection, const ModbusRequest& request, double now_s) {
  const bool is_input = request.function == ModbusFunction::ReadInput;
  const std::size_t size = is_input ? kInputRegisters : kHoldingRegisters;
  const std::size_t end = std::size_t{request.read_address} + request.read_count;
  if (request.read_count > 0 && end > size)
    return modbusRefusal(refused(request, ModbusException::IllegalAddress));
  if (!request.written.empty())
    if (const auto exception = write(connection, request, now_s))
      return modbusRefusal(refused(request, *exception));
  if (request.read_count == 0) return modbusAnswer(request, {});
  return modbusAnswer(request, is_input ? slice(registers(now_s), request.read_address, request.read_count)
                                        : slice(holding_, request.read_address, request.read_count));
}

std::optional<ModbusException> PlcLink::write(int connection, const ModbusRequest& request, double now_s) {
  HoldingRegisters after = holding_;
  for (std::size_t i = 0; i < request.written.size(); ++i) {
    const std::size_t address = request.write_address + i;
    if (!isWritable(address)) return ModbusException::IllegalAddress;
    after.at(address) = request.written[i];
  }
  if (!areInRange(after, settings_.word_order)) return ModbusException::IllegalValue;
  forgetStop(connection, request);
  if (isStopAlone(request) && writer_ != connection) {
    takeStop(connection, request);
    return std::nullopt;
  }
  if (writer_.value_or(connection) != connection) return ModbusException::ServerBusy;
  writer_ = connection;
  if (surroundings(after) != surroundings(holding_)) ++news_;
  const HoldingRegisters before = std::exchange(holding_, after);
  if (holding_[kHeartbeatRegister] != before[kHeartbeatRegister]) {
    figures_.plc_heartbeat = holding_[kHeartbeatRegister];
    has_beaten_ = true;
    heard_s_ = now_s;
    if (watchdog_ == PlcHeartbeat::Unarmed && access_ == RemoteAccess::Allowed)
      watchdog_ = PlcHeartbeat::Good;
  }
  findOrders(connection, request, before);
  const bool was_plate_written = isPlateWritten();
  for (std::size_t i = 0; i < request.written.size(); ++i) written_.set(request.write_address + i);
  if (isPlateWritten() != was_plate_written) ++news_;
  return std::nullopt;
}

/// Leaves the registers as the connection that writes has them: what it writes again is no new command.
void PlcLink::takeStop(int connection, const ModbusRequest& request) {
  const std::uint16_t sequence = request.written[1];
  const std::uint16_t last = std::exchange(stops_[connection], sequence);
  if (sequence != 0 && sequence != last) order({PlcOrder::Kind::Command, request.written[0], sequence});
}

/// Another sequence lets a button go, also where the write is refused: its next press counts again.
void PlcLink::forgetStop(int connection, const ModbusRequest& request) {
  const auto stop = stops_.find(connection);
  const auto sequence = writtenTo(kCommandSequenceRegister, request);
  if (stop != stops_.end() && sequence && *sequence != stop->second) stops_.erase(stop);
}

void PlcLink::findOrders(int connection, const ModbusRequest& request, const HoldingRegisters& before) {
  using Kind = PlcOrder::Kind;
  const PlcInputs now = inputs();
  const bool is_stop = isStopAlone(request);
  const auto find = [&](std::size_t at, const PlcOrder& found) {
    if (holding_.at(at) == 0 || holding_.at(at) == before.at(at)) return;
    // What a PLC writes again to a link that was restarted was carried out by the link before.
    if (!written_.test(at) && !is_stop) return setResult(found, CommandResult::StaleSequence);
    order(found);
  };
  find(kModeSequenceRegister, {Kind::Mode, now.mode, now.mode_sequence});
  find(kJobSequenceRegister, {Kind::Job, now.job, now.job_sequence});
  find(kAcknowledgedRegister, {Kind::Acknowledge, now.acknowledged_alarm, 0});
  // A stop that it wrote before it was the one that writes was carried out then.
  const auto stop = stops_.find(connection);
  if (stop != stops_.end() && stop->second == now.command_sequence) return;
  find(kCommandSequenceRegister, {Kind::Command, now.command, now.command_sequence});
}

bool PlcLink::isPlateWritten() const { return written_.test(kPlateRegister); }

void PlcLink::order(const PlcOrder& order) {
  const bool is_command = order.kind == PlcOrder::Kind::Command;
  const bool stops = is_command && isStopping(order.value);
  if (is_command && !unitCommand(static_cast<int>(std::min<std::uint32_t>(order.value, 1000))))
    return setResult(order, CommandResult::BadValue);
  if (access_ == RemoteAccess::Locked && !stops) return setResult(order, CommandResult::RemoteLocked);
  if ((watchdog_ == PlcHeartbeat::Lost || watchdog_ == PlcHeartbeat::Abandoned) && !stops)
    return setResult(order, CommandResult::WatchdogLost);
  if (presence_ == UnitPresence::Lost && !stops) return setResult(order, CommandResult::Busy);
  orders_.push_back(order);
}

void PlcLink::close(int connection) {
  if (writer_ == connection) writer_.reset();
  stops_.erase(connection);
}

std::vector<PlcOrder> PlcLink::takeOrders() { return std::exchange(orders_, {}); }

void PlcLink::setResult(const PlcOrder& order, CommandResult result) {
  if (order.kind != PlcOrder::Kind::Command) return;
  was_refused_ = result != CommandResult::Accepted;
  figures_.result = static_cast<std::uint16_t>(result);
  figures_.answered_sequence = order.sequence;
  figures_.last_command = static_cast<std::uint16_t>(order.value);
}

void PlcLink::setPresence(UnitPresence presence, double now_s) {
  if (presence == UnitPresence::Lost && presence_ == UnitPresence::Present) lost_s_ = now_s;
  presence_ = presence;
}

PlcHeartbeat PlcLink::watch(double now_s) {
  const double silent_s = now_s - heard_s_;
  if (watchdog_ == PlcHeartbeat::Unarmed) return watchdog_;
  if (silent_s <= settings_.watchdog_s) return watchdog_ = PlcHeartbeat::Good;
  if (watchdog_ == PlcHeartbeat::Good) {
    watchdog_ = PlcHeartbeat::Lost;
    writer_.reset();  // its connection may be a dead one: whoever calls next may write
  } else if (silent_s > settings_.abandon_s) {
    watchdog_ = PlcHeartbeat::Abandoned;
  }
  return watchdog_;
}

InputRegisters PlcLink::registers(double now_s) const {
  PlcStatus status = status_;
  if (isAlive()) status.flags.push_back(StatusFlag::WatchdogGood);
  if (access_ == RemoteAccess::Allowed) status.flags.push_back(StatusFlag::RemoteAllowed);
  if (was_refused_) status.flags.push_back(StatusFlag::CommandRefused);
  LinkFigures figures = figures_;
  const double beats_s = presence_ == UnitPresence::Present ? now_s : lost_s_;
  figures.heartbeat =
      static_cast<std::uint16_t>(std::fmod(std::floor(beats_s / kHeartbeatInterval), 65536.0));
  return inputRegisters(status, figures, settings_.word_order);
}

}  // namespace lamina
