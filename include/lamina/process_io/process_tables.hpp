// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// The quantity of a channel, in the order in which channels are set to safe values: the beam first, gas and
/// fan last.
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

/// Name of a quantity, with its unit: "laser", "laser_power_w", "wire", "wire_speed_mm_s", "screw_rpm",
/// "flow_mm3_s", "powder", "powder_g_min", "gas", "gas_l_min", "fan". Switches are 0 or 1, the fan a share.
const char* nameOf(ProcessQuantity quantity);

/// Whether the quantity switches or powers the beam.
constexpr bool isBeam(ProcessQuantity quantity) { return quantity <= ProcessQuantity::LaserPower; }

/// An output of a device. The raw value sent is scale * value + offset.
struct OutputChannel {
  std::string name;
  ProcessQuantity quantity = ProcessQuantity::LaserPower;
  std::string device;
  std::string write;  ///< place in the device: a register, a text with {value}, a pin, a topic
  double scale = 1.0;
  double offset = 0.0;
  double low = 0.0;   ///< lower bound of values that are sent while the channel is on [unit of the quantity]
  double high = 0.0;  ///< upper bound; must be above `low`
  double safe = 0.0;  ///< sent while the channel is off, and whenever there is a fault; may lie below `low`
  double nominal = 0.0;      ///< sent while the process is on and no value is stated; 0 is off
  double slew_per_s = 0.0;   ///< greatest change in a second between `low` and `high`; 0 for no limit
  double dead_time_s = 0.0;  ///< time from sending a value to the begin of its effect
  double lag_s = 0.0;        ///< time constant of the effect after the dead time
  /// Diameter of the wire, for computing its speed from the flow; 0 if it is not computed.
  double wire_diameter_mm = 0.0;
  /// Table for computing a screw's speed from the flow: rpm, mm³ per revolution, rpm, mm³ ...
  std::vector<double> screw;
  int fault_register = -1;  ///< register of a Modbus device's own value for a lost link; -1 for none
};

/// How an input is checked.
enum class InputCheck : std::uint8_t {
  Shown,    ///< not at all
  Follows,  ///< must equal the effect of a channel within the tolerance; otherwise alarm 5101
  Present,  ///< must be `least` or more while a channel is on; otherwise 5106 for wire, 5107 for others
  Ready,    ///< must be `least` or more at all times; otherwise 5102
};

/// An input of a device. The raw value read is scale * value + offset.
struct InputChannel {
  std::string name;
  std::string device;
  int read = 0;            ///< number of the register
  bool is_signed = false;  ///< whether the register is a two's complement
  double scale = 1.0;
  double offset = 0.0;
  InputCheck check = InputCheck::Shown;
  std::string channel;     ///< name of the channel that Follows and Present refer to
  double tolerance = 0.0;  ///< [unit of the channel's quantity]
  double least = 0.5;
  double after_s = 0.5;  ///< time for which the input must be wrong before an alarm is raised
};

enum class DeviceKind : std::uint8_t { ModbusTcp, ModbusRtu, SerialText, SetIo, Topic, None };
enum class Parity : std::uint8_t { None, Even, Odd };

/// A device that has outputs or inputs.
struct DeviceSettings {
  std::string name;
  DeviceKind kind = DeviceKind::None;
  std::string address;  ///< host:port, path of a serial port, service; empty for topics
  int baud = 19200;
  Parity parity = Parity::Even;   ///< of Modbus RTU
  int unit = 1;                   ///< unit number of Modbus
  double timeout_s = 0.2;         ///< longest wait for an answer; after that the link counts as lost
  double retry_s = 1.0;           ///< time from the loss of a link to the next attempt
  std::string answer;             ///< answer of a serial device to each line; empty if it gives none
  int watchdog_register = -1;     ///< register that holds the device's watchdog time; -1 if it cannot be read
  double watchdog_unit_s = 1e-3;  ///< unit of that register
  double watchdog_most_s = 0.5;   ///< longest watchdog time that is accepted
};

/// The devices of process_io, with their outputs and inputs.
struct ProcessTables {
  std::vector<DeviceSettings> devices;
  std::vector<OutputChannel> channels;  ///< those of the beam first
  std::vector<InputChannel> inputs;
};

/// The tables as settings: keys of rows begin with the row's name, "laser.scale".
struct ProcessTableSettings {
  SettingTable devices;
  SettingTable channels;
  SettingTable inputs;
};

/// Adds the keys devices, channels and inputs.
void describe(SettingsSchema& schema, ProcessTableSettings& settings);

/// Reads the tables from the settings.
/// @throws InvalidConfig naming row, key, value and bound; also if a band is empty, a device or channel is
///   unknown, or a table of a screw does not rise
ProcessTables processTables(const ProcessTableSettings& settings);

/// Speed of a screw for a flow [rpm]. The volume per revolution is linear between the entries of the screw's
/// table, and beyond them that of the nearest entry. 0 for no flow.
/// @param screw  as in `OutputChannel`, not empty
double screwSpeed(double flow_mm3_s, const std::vector<double>& screw);

}  // namespace lamina
