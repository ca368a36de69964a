// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/register_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lamina {
namespace {

constexpr std::size_t kAlarmPlaces = 8;
constexpr std::size_t kNameRegisters = 32;
constexpr std::size_t kBadgeRegisters = 16;
constexpr double kSlowest = 0.5;
constexpr double kFastest = 1.2;

std::uint32_t bitsOf(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float floatOf(std::uint32_t bits) {
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Writes values into registers, 32-bit ones in the order that was asked for.
class RegisterWriter {
 public:
  explicit RegisterWriter(WordOrder order) : order_(order) {}

  void put(std::size_t at, std::uint16_t value) { registers_.at(at) = value; }

  void putLong(std::size_t at, std::uint32_t value) {
    const auto high = static_cast<std::uint16_t>(value >> 16U);
    const auto low = static_cast<std::uint16_t>(value & 0xffffU);
    registers_.at(at) = order_ == WordOrder::HighFirst ? high : low;
    registers_.at(at + 1) = order_ == WordOrder::HighFirst ? low : high;
  }

  void putLong(std::size_t at, std::int32_t value) { putLong(at, static_cast<std::uint32_t>(value)); }
  void putFloat(std::size_t at, float value) { putLong(at, bitsOf(value)); }

  void putText(std::size_t at, const std::string& text, std::size_t registers) {
    for (std::size_t i = 0; i < 2 * registers && i < text.size(); ++i) {
      const unsigned shift = i % 2 == 0 ? 8U : 0U;
      registers_.at(at + i / 2) |= static_cast<std::uint16_t>(static_cast<std::uint8_t>(text[i]) << shift);
    }
  }

  const InputRegisters& registers() const { return registers_; }

 private:
  WordOrder order_;
  InputRegisters registers_{};
};

std::uint32_t longAt(const HoldingRegisters& registers, std::size_t at, WordOrder order) {
  const std::uint32_t first = registers.at(at);
  const std::uint32_t second = registers.at(at + 1);
  return order == WordOrder::HighFirst ? (first << 16U) | second : (second << 16U) | first;
}

/// The text without a character that does not fit whole.
std::string firstCharacters(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes;
  while (end > 0 && (static_cast<std::uint8_t>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end);
}

std::string textAt(const HoldingRegisters& registers, std::size_t at, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += static_cast<char>(registers.at(at + i) >> 8U);
    text += static_cast<char>(registers.at(at + i) & 0xffU);
  }
  return text.substr(0, text.find('\0'));
}

std::uint16_t flagBits(const std::vector<StatusFlag>& flags) {
  unsigned bits = 0;
  for (const StatusFlag flag : flags) bits |= 1U << static_cast<unsigned>(flag);
  return static_cast<std::uint16_t>(bits);
}

bool hasBit(std::uint16_t word, unsigned bit) { return ((word >> bit) & 1U) != 0; }

bool isAlarm(const ActiveAlarm& alarm) { return alarm.category > AlarmCategory::Warning; }

void putAlarms(RegisterWriter& writer, const std::vector<ActiveAlarm>& alarms) {
  std::size_t place = 0;
  for (const ActiveAlarm& alarm : alarms) {
    if (!isAlarm(alarm) || place == kAlarmPlaces) continue;
    writer.put(20 + 2 * place, alarm.id);
    const double value = std::isfinite(alarm.value) ? alarm.value : 0.0;
    const double whole = std::clamp(std::round(value), -2147483648.0, 2147483647.0);
    writer.put(21 + 2 * place, static_cast<std::uint16_t>(static_cast<std::int32_t>(whole) & 0xffff));
    ++place;
  }
  const auto count = static_cast<std::size_t>(std::count_if(alarms.begin(), alarms.end(), isAlarm));
  writer.put(18, static_cast<std::uint16_t>(count));
  writer.put(19, static_cast<std::uint16_t>(alarms.size() - count));
}

void putJob(RegisterWriter& writer, const JobStatus& job) {
  writer.putLong(40, job.id);
  writer.put(42, job.state);
  writer.put(43, job.queued);
  writer.putLong(94, job.next);
  writer.putLong(44, job.layer);
  writer.putLong(46, job.layers);
  writer.putFloat(48, job.fraction);
  writer.putLong(50, job.gone_s);
  writer.putLong(52, job.left_s);
  writer.putLong(54, job.line);
  writer.putFloat(56, job.path_mm);
  writer.putText(100, firstCharacters(job.name, 2 * kNameRegisters), kNameRegisters);
}

void putProcess(RegisterWriter& writer, const ProcessFigures& process) {
  const std::array<float, 10> values = {process.nozzle_c,       process.bed_c,   process.flow_mm3_s,
                                        process.tip_speed_mm_s, process.laser_w, process.wire_mm_s,
                                        process.mean_error_mm,  process.rmse_mm, process.coverage,
                                        process.mean_correction};
  for (std::size_t i = 0; i < values.size(); ++i) writer.putFloat(60 + 2 * i, values.at(i));
}

void putCounters(RegisterWriter& writer, const PlcStatus& status) {
  writer.putLong(80, rolledOver(static_cast<double>(status.counters.parts)));
  writer.putLong(82, rolledOver(static_cast<double>(status.counters.defective)));
  writer.putLong(84, rolledOver(totalTime(status.counters)));
  writer.putLong(86, rolledOver(status.in_state_s));
  writer.putLong(88, rolledOver(status.in_mode_s));
  const double seconds = std::floor(std::max(0.0, status.utc_s));
  writer.putLong(90, static_cast<std::uint32_t>(std::fmod(seconds, 4294967296.0)));
  writer.put(92, static_cast<std::uint16_t>((std::max(0.0, status.utc_s) - seconds) * 1e3));
  writer.put(93, status.is_clock_synchronised ? 1 : 0);
}

}  // namespace

InputRegisters inputRegisters(const PlcStatus& status, const LinkFigures& link, WordOrder order) {
  RegisterWriter writer(order);
  writer.put(0, kRegisterMapVersion);
  writer.put(1, link.heartbeat);
  writer.put(2, link.plc_heartbeat);
  writer.put(3, flagBits(status.flags));
  writer.putLong(4, std::uint32_t{0x12345678});
  writer.putFloat(6, 1234.5F);
  writer.put(8, static_cast<std::uint16_t>(status.mode));
  writer.put(9, static_cast<std::uint16_t>(status.mode_requested));
  writer.put(10, static_cast<std::uint16_t>(status.state));
  writer.put(11, static_cast<std::uint16_t>(status.state_requested));
  writer.put(12, link.last_command);
  writer.put(13, link.answered_sequence);
  writer.put(14, link.result);
  writer.put(15, status.stop_reason);
  writer.putLong(16, status.stop_value);
  putAlarms(writer, status.alarms);
  putJob(writer, status.job);
  putProcess(writer, status.process);
  putCounters(writer, status);
  return writer.registers();
}

PlcInputs plcInputs(const HoldingRegisters& registers, WordOrder order) {
  PlcInputs inputs;
  inputs.heartbeat = registers.at(0);
  inputs.command = registers.at(1);
  inputs.command_sequence = registers.at(2);
  inputs.mode = registers.at(3);
  inputs.mode_sequence = registers.at(4);
  inputs.job = longAt(registers, 5, order);
  inputs.job_sequence = registers.at(7);
  inputs.has_material = hasBit(registers.at(8), 0);
  inputs.has_gas = hasBit(registers.at(8), 1);
  inputs.has_cooling = hasBit(registers.at(8), 2);
  inputs.has_vacuum = hasBit(registers.at(8), 3);
  inputs.is_blocked = hasBit(registers.at(9), 0);
  inputs.is_starved = hasBit(registers.at(9), 1);
  inputs.is_guard_closed = hasBit(registers.at(10), 0);
  inputs.is_guard_reset = hasBit(registers.at(10), 1);
  inputs.is_emergency_stop_pressed = hasBit(registers.at(10), 2);
  inputs.is_plate_there = hasBit(registers.at(11), 0);
  inputs.is_plate_clamped = hasBit(registers.at(11), 1);
  inputs.is_part_removed = hasBit(registers.at(11), 2);
  inputs.is_zone_taken = hasBit(registers.at(11), 3);
  const std::uint32_t speed = longAt(registers, 12, order);
  inputs.speed = speed == 0 ? 1.0 : static_cast<double>(floatOf(speed));
  inputs.acknowledged_alarm = registers.at(14);
  inputs.badge = textAt(registers, 20, kBadgeRegisters);
  return inputs;
}

bool areInRange(const HoldingRegisters& registers, WordOrder order) {
  const double speed = plcInputs(registers, order).speed;
  return speed >= kSlowest && speed <= static_cast<double>(static_cast<float>(kFastest));
}

bool isWritable(std::size_t address) {
  return address <= 14 || (address >= 20 && address < kHoldingRegisters);
}

}  // namespace lamina
