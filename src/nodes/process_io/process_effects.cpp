// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "process_effects.hpp"

#include <ros/time.h>

#include <cmath>
#include <limits>

#include "joint_messages.hpp"

namespace lamina {
namespace {

constexpr double kOnShare = 0.01;  // of the band: what is on

/// What devices read of a channel; NaN if none does.
double measuredOf(const OutputChannel& channel, const ProcessTables& tables,
                  const std::vector<double>& measured) {
  for (std::size_t i = 0; i < tables.inputs.size(); ++i)
    if (tables.inputs[i].check == InputCheck::Follows && tables.inputs[i].channel == channel.name)
      return measured[i];
  return std::numeric_limits<double>::quiet_NaN();
}

/// Puts the effect of a channel in.
void setEffect(const OutputChannel& channel, double value, ProcessSignals& signals) {
  const bool is_on = value - channel.safe > kOnShare * (channel.high - channel.low);
  ProcessLevels& levels = signals.levels;
  switch (channel.quantity) {
    case ProcessQuantity::LaserPower:
      levels[ProcessLevel::LaserPower] = value;
      [[fallthrough]];
    case ProcessQuantity::LaserOn:
      signals.is_laser_on = signals.is_laser_on || is_on;
      break;
    case ProcessQuantity::WireSpeed:
      levels[ProcessLevel::WireSpeed] = value;
      [[fallthrough]];
    case ProcessQuantity::WireOn:
      signals.is_wire_fed = signals.is_wire_fed || is_on;
      break;
    case ProcessQuantity::Powder:
      levels[ProcessLevel::Powder] = value;
      [[fallthrough]];
    case ProcessQuantity::PowderOn:
      signals.is_powder_on = signals.is_powder_on || is_on;
      break;
    case ProcessQuantity::Gas:
      levels[ProcessLevel::Gas] = value;
      [[fallthrough]];
    case ProcessQuantity::GasOn:
      signals.is_gas_on = signals.is_gas_on || is_on;
      break;
    case ProcessQuantity::ScrewSpeed:
      levels[ProcessLevel::ScrewSpeed] = value;
      break;
    case ProcessQuantity::Fan:
      levels[ProcessLevel::Fan] = value;
      break;
    case ProcessQuantity::Flow:
      signals.flow_mm3_s = value;
      break;
  }
}

}  // namespace

lamina_msgs::ProcessState effectsMessage(const ProcessTables& tables, const std::vector<ChannelDrive>& drives,
                                         const std::vector<double>& measured) {
  ProcessSignals signals;
  std::vector<lamina_msgs::ProcessOutput> outputs;
  for (const ChannelDrive& drive : drives) {
    lamina_msgs::ProcessOutput output;
    output.name = drive.channel().name;
    output.quantity = nameOf(drive.channel().quantity);
    output.commanded = drive.sent();
    output.expected = drive.expected();
    output.measured = measuredOf(drive.channel(), tables, measured);
    setEffect(drive.channel(), std::isnan(output.measured) ? output.expected : output.measured, signals);
    outputs.push_back(std::move(output));
  }
  lamina_msgs::ProcessState state = toStateMessage(signals);
  state.outputs = std::move(outputs);
  return state;
}

lamina_msgs::AlarmReport toReport(const ProcessAlarm& alarm) {
  lamina_msgs::AlarmReport report;
  report.header.stamp = ros::Time::now();
  report.id = alarm.id;
  // Ends are told once for all devices of an alarm: to the unit they have one source.
  report.source = "process_io";
  report.value = alarm.value;
  report.message = alarm.message;
  report.is_gone = alarm.is_gone;
  return report;
}

}  // namespace lamina
