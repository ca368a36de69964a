// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What a channel carries, in the order in which channels go to safe values: the beam first, gas last.
enum class ProcessQuantity : std::uint8_t {
  LaserOn,  ///< switch of beam or arc
  LaserPower,
  WireOn,
  WireSpeed,
  ScrewSpeed,
  Flow,
  PowderOn,
  Powder,
  GasOn,
  Gas,
  Fan,
};

/// With its unit: "laser", "laser_power_w", "wire", "wire_speed_mm_s", "screw_rpm", "flow_mm3_s", "powder",
/// "powder_g_min", "gas", "gas_l_min", "fan". Switches are 0 or 1, the fan a share.
const char* nameOf(ProcessQuantity quantity);

/// Whether it is, or lights, the beam.
constexpr bool isBeam(ProcessQuantity quantity) { return quantity <= ProcessQuantity::LaserPower; }

/// A value on its way to a device. Raw values of devices are scale * value + offset.
struct OutputChannel {
  std::string name;
  ProcessQuantity quantity = ProcessQuantity::LaserPower;
  std::string device;
  std::string write;  ///< where in the device: a register, a text with {value}, a pin, a topic
  double scale = 1.0;
  double offset = 0.0;
  double low = 0.0;          ///< band of what is sent while the process is on [unit of the quantity]
  double high = 0.0;         ///< must be above
  double safe = 0.0;         ///< sent while it is off, and whenever anything is wrong; may lie below the band
  double nominal = 0.0;      ///< sent where the process is on and nothing states a value; 0 is off
  double slew_per_s = 0.0;   ///< greatest change within the band; 0 for no limit
  double dead_time_s = 0.0;  ///< from sending a value to the begin of its effect
  double lag_s = 0.0;        ///< time constant of the effect behind that
  double wire_diameter_mm = 0.0;  ///< of a wire speed that follows from the flow; 0 if it does not
  std::vector<double> screw;  ///< rpm, mm³ per revolution, rpm, mm³ ...: of a speed that follows from it
  int fault_register = -1;    ///< of a Modbus device's own value for a lost link; -1 for none
};

/// How an input is judged.
enum class InputCheck : std::uint8_t {
  Shown,    ///< not at all
  Follows,  ///< is the effect of a channel, within the tolerance: else 5101
  Present,  ///< is at least `least` while a channel is on: else 5106 of wire, 5107 of anything else
  Ready,    ///< is at least `least` all the time: else 5102
};

/// A value that a device reads. Scaled as outputs are.
struct InputChannel {
  std::string name;
  std::string device;
  int read = 0;  ///< register
  double scale = 1.0;
  double offset = 0.0;
  InputCheck check = InputCheck::Shown;
  std::string channel;     ///< that it follows, or is present with
  double tolerance = 0.0;  ///< [unit of the channel's quantity]
  double least = 0.5;
  double after_s = 0.5;  ///< for which it must be wrong
};

enum class DeviceKind : std::uint8_t { ModbusTcp, ModbusRtu, SerialText, SetIo, Topic, None };
enum class Parity : std::uint8_t { None, Even, Odd };

/// A device that channels go to.
struct DeviceSettings {
  std::string name;
  DeviceKind kind = DeviceKind::None;
  std::string address;  ///< host:port, path of a serial port, service; empty for topics
  int baud = 19200;
  Parity parity = Parity::Even;  ///< of Modbus RTU
  int unit = 1;                  ///< of Modbus
  double timeout_s = 0.2;        ///< for an answer: then the link is lost
  double retry_s = 1.0;          ///< from a lost link to the next try
  std::string answer;            ///< of a serial line to each line; empty if it gives none
  int watchdog_register = -1;    ///< that holds the device's watchdog time; -1 if it cannot be read
  double watchdog_unit_s = 1e-3;
  double watchdog_most_s = 0.5;  ///< longest that is accepted
};

/// What process_io is connected with.
struct ProcessTables {
  std::vector<DeviceSettings> devices;
  std::vector<OutputChannel> channels;  ///< the beam's first
  std::vector<InputChannel> inputs;
};

/// The same as settings: rows by names, "laser.scale".
struct ProcessTableSettings {
  SettingTable devices;
  SettingTable channels;
  SettingTable inputs;
};

/// Adds the keys devices, channels and inputs.
void describe(SettingsSchema& schema, ProcessTableSettings& settings);

/// @throws InvalidConfig naming row, key, value and bound; also if a band is empty, a device or channel is
///   unknown, or a table of a screw does not rise
ProcessTables processTables(const ProcessTableSettings& settings);

/// Speed of a screw for a flow [rpm], between the entries of its table in proportion to the volume per
/// revolution; beyond them as at the nearest one. 0 for no flow.
/// @param screw  as in `OutputChannel`, not empty
double screwSpeed(double flow_mm3_s, const std::vector<double>& screw);

}  // namespace lamina
