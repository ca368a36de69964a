// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/alarm_table.hpp"

#include <algorithm>
#include <array>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Category = AlarmCategory;
constexpr AlarmCause kEvent = AlarmCause::Event;
constexpr AlarmCause kCondition = AlarmCause::Condition;

std::vector<AlarmKind> unitAlarms() {
  return {
      {1001, Category::Information, kEvent, "held by the operator", "Unhold to go on."},
      {1002, Category::Information, kEvent, "aborted by the operator", "Clear, then Reset."},
      {1010, Category::Abort, kEvent, "a state lasted too long",
       "Look at what the executor waits for; Clear starts anew."},
      {1201, Category::Suspend, kCondition, "no build plate", "Put a plate in; the PLC says so."},
      {1202, Category::Suspend, kCondition, "build plate not clamped", "Clamp the plate."},
      {1203, Category::Suspend, kCondition, "part not removed", "Take the part out and confirm it."},
      {1204, Category::Suspend, kCondition, "zone taken by another robot",
       "Wait until it has left the zone."},
      {1205, Category::Suspend, kCondition, "material, gas or cooling missing",
       "Fill up or open what is named."},
      {1206, Category::Suspend, kCondition, "blocked downstream", "Free the place that takes the parts."},
      {1207, Category::Stop, kCondition, "emergency stop pressed",
       "Find out why; release it, then Clear or Reset, and Start at the machine."},
      {1208, Category::Hold, kEvent, "guard opened", "Close and reset the guard, then go on."},
  };
}

std::vector<AlarmKind> linkAlarms() {
  return {
      {2101, Category::Hold, kCondition, "PLC silent",
       "Look at the PLC, its cable, and its heartbeat register."},
      {2102, Category::Warning, kEvent, "PLC commands refused repeatedly",
       "Compare the PLC's program with the states that accept its command."},
      {2103, Category::Warning, kEvent, "malformed Modbus frames",
       "Look for a second client, a wrong word order, or a port scan."},
      {2201, Category::Hold, kCondition, "executor lost", "Look whether it runs, and at its log."},
      {2202, Category::Abort, kEvent, "executor does not answer",
       "Look at its log; Clear connects anew; if it was ended, it has stopped its machine, and lamina resume "
       "makes a program of the rest."},
      {2203, Category::Abort, kEvent, "machine stopped in its executor's place",
       "Find out why the executor died; what was under way does not go on from here by itself."},
      {2204, Category::Abort, kCondition, "machine without executor not stopped",
       "Look after the machine: it may be hot, and moving."},
  };
}

std::vector<AlarmKind> machineAlarms() {
  return {
      {3101, Category::Abort, kEvent, "link to the machine lost",
       "Look at cable and power; Clear connects anew."},
      {3102, Category::Abort, kEvent, "machine reset", "Find out why it restarted before going on."},
      {3103, Category::Abort, kEvent, "machine halted", "Reset the machine at its own controls."},
      {3104, Category::Abort, kEvent, "heater fault", "Look at heater and thermistor before heating again."},
      {3105, Category::Abort, kEvent, "machine silent", "Look at cable and power."},
      {3106, Category::Abort, kEvent, "firmware error", "Read what the firmware said; correct the program."},
      {3201, Category::Hold, kCondition, "bed cold", "Let it heat; a part may have come loose."},
      {3202, Category::Hold, kCondition, "vacuum lost", "Look at pump and sheet; a part may have moved."},
      {3203, Category::Hold, kCondition, "homing lost",
       "Home the axes that can be homed with the part there."},
      {3204, Category::Hold, kCondition, "dryer out of band", "Wait until the material is dry."},
  };
}

std::vector<AlarmKind> motionAlarms() {
  return {
      {4101, Category::Abort, kEvent, "tip off its path", "Look for a collision or a slipping axis."},
      {4102, Category::Warning, kEvent, "controller starved",
       "Look at the load of the host and the network."},
      {4103, Category::Abort, kEvent, "controller refused a trajectory",
       "Read its reason; check the program."},
      {4104, Category::Hold, kCondition, "way back not free", "Choose another approach, or move by hand."},
      {4105, Category::Abort, kEvent, "toolpath cannot be driven",
       "Read where and why; check it with lamina check on this machine, and queue another."},
      {4106, Category::Abort, kEvent, "driver gave the job up", "Read its reason, and its log."},
      {5101, Category::Hold, kCondition, "process value out of band", "Look at the device that is named."},
      {5102, Category::Hold, kCondition, "process device not ready", "Make the device ready."},
      {5103, Category::Warning, kEvent, "process output late", "Look at the load of the host."},
      {5104, Category::Abort, kEvent, "process output far too late",
       "Look at the load of the host and the link."},
      {5105, Category::Abort, kEvent, "beam or arc on without motion",
       "Look at the interlock and the device."},
      {5106, Category::Hold, kCondition, "wire stuck",
       "Free the wire; look at the liner and the drive rolls."},
      {5107, Category::Hold, kCondition, "no flow", "Look at hopper, nozzle and temperature."},
  };
}

std::vector<AlarmKind> loopAlarms() {
  return {
      {6101, Category::Warning, kCondition, "height sensor silent", "Look at the sensor and its driver."},
      {6102, Category::Warning, kCondition, "no pose of the nozzle for clouds", "Look at tf and the clocks."},
      {6103, Category::Warning, kCondition, "height sensor stuck", "Clean the sensor's window."},
      {6104, Category::Warning, kEvent, "points not believed", "Look for spatter, smoke or mirrors."},
      {6105, Category::Warning, kCondition, "sensor or its time offset has moved", "Calibrate the sensor."},
      {6106, Category::Warning, kEvent, "estimator inconsistent", "Calibrate noise and gain."},
      {6110, Category::Hold, kEvent, "height jumped", "Look at the part: something broke or came off."},
      {6111, Category::Warning, kEvent, "height off in too many places", "Look at the deviation picture."},
      {6112, Category::Hold, kEvent, "lump under the head's way", "Take the lump off."},
      {6113, Category::Warning, kEvent, "corrections at their limits",
       "Plan the layers left anew, or go on as it is."},
      {6114, Category::Warning, kEvent, "height error grows", "Look at feeder and sensor; the loop coasts."},
      {6115, Category::Warning, kEvent, "feeder's gain out of range", "Look at feeder, nozzle and material."},
      {6116, Category::Warning, kEvent, "correction map late", "Look at the load of the host."},
  };
}

std::vector<AlarmKind> hostAlarms() {
  return {
      {7001, Category::Warning, kCondition, "journal damaged", "It was moved aside; a new one has begun."},
      {7002, Category::Warning, kCondition, "disk nearly full", "Free space; jobs are refused below 1 GiB."},
      {7003, Category::Hold, kCondition, "journal cannot be written",
       "Free space or mount the disk writable."},
      {7101, Category::Hold, kCondition, "a file no longer has its hash", "Upload the job anew."},
      {7102, Category::Hold, kCondition, "place to resume uncertain",
       "Scan the part, or say where it ended."},
      {8001, Category::Hold, kCondition, "host lost", "Look at its power and network."},
      {8002, Category::Warning, kCondition, "ROS master lost",
       "The job goes on; nothing starts until it is back."},
      {8003, Category::Warning, kCondition, "clocks apart", "Look at chrony on both hosts."},
      {8004, Category::Hold, kCondition, "clocks far apart", "Look at chrony on both hosts."},
      {8005, Category::Warning, kEvent, "a node was restarted", "Read its log."},
      {9001, Category::Warning, kEvent, "tokens guessed", "Look where the requests come from."},
      {9002, Category::Information, kCondition, "reachable from outside this host",
       "Wanted: nothing to do. Else bind to 127.0.0.1."},
      {9003, Category::Warning, kCondition, "audit chain broken",
       "Keep the journal as it is and find out who wrote."},
  };
}

}  // namespace

char letterOf(AlarmCategory category) {
  constexpr std::array<char, 6> kLetters = {'I', 'W', 'S', 'H', 'T', 'A'};
  return kLetters.at(static_cast<std::size_t>(category));
}

const std::vector<AlarmKind>& alarmTable() {
  static const std::vector<AlarmKind> kTable = [] {
    std::vector<AlarmKind> table;
    for (const auto& group :
         {unitAlarms(), linkAlarms(), machineAlarms(), motionAlarms(), loopAlarms(), hostAlarms()})
      table.insert(table.end(), group.begin(), group.end());
    return table;
  }();
  return kTable;
}

const AlarmKind& alarmKind(int id) {
  const std::vector<AlarmKind>& table = alarmTable();
  const auto found = std::lower_bound(table.begin(), table.end(), id,
                                      [](const AlarmKind& kind, int sought) { return kind.id < sought; });
  if (found == table.end() || found->id != id)
    throw InvalidInput("alarm " + std::to_string(id) +
                       " is not known; expected an ID of the table of alarms");
  return *found;
}

std::string alarmTableCsv() {
  std::string csv = "id,category,title,remedy\n";
  for (const AlarmKind& kind : alarmTable())
    csv += std::to_string(kind.id) + ',' + letterOf(kind.category) + ",\"" + kind.title + "\",\"" +
           kind.remedy + "\"\n";
  return csv;
}

}  // namespace lamina
