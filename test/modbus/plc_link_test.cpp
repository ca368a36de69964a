// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/plc_link.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lamina {
namespace {

ModbusRequest reading(ModbusFunction function, std::uint16_t address, std::uint16_t count) {
  ModbusRequest request;
  request.function = function;
  request.read_address = address;
  request.read_count = count;
  return request;
}

ModbusRequest writing(std::uint16_t address, const std::vector<std::uint16_t>& values) {
  ModbusRequest request;
  request.function = ModbusFunction::WriteMany;
  request.write_address = address;
  request.written = values;
  return request;
}

/// The values in an answer to a read.
std::vector<std::uint16_t> valuesOf(const std::string& answer) {
  std::vector<std::uint16_t> values;
  for (std::size_t at = 9; at + 1 < answer.size(); at += 2)
    values.push_back(static_cast<std::uint16_t>((static_cast<unsigned char>(answer[at]) << 8) |
                                                static_cast<unsigned char>(answer[at + 1])));
  return values;
}

/// The exception code in an answer; 0 if it is none.
int exceptionOf(const std::string& answer) {
  return (static_cast<unsigned char>(answer[7]) & 0x80) != 0 ? static_cast<unsigned char>(answer[8]) : 0;
}

/// A link that was just started.
PlcLink startedLink() {
  PlcLink link{PlcLinkSettings{}};
  link.setRemoteAccess(RemoteAccess::Allowed);
  link.setPresence(UnitPresence::Present, 0.0);
  return link;
}

/// Writes zeros to command, mode, job and acknowledgement, so that their next values count.
void clearOrders(PlcLink& link) {
  link.answer(1, writing(1, std::vector<std::uint16_t>(7, 0)), 0.0);
  link.answer(1, writing(14, {0}), 0.0);
}

PlcLink openLink() {
  PlcLink link = startedLink();
  clearOrders(link);
  return link;
}

TEST(RegisterMap, LetsAProgrammerCheckItsWordOrder) {
  const InputRegisters high = inputRegisters({}, {}, WordOrder::HighFirst);
  EXPECT_EQ(high[0], 1);
  EXPECT_EQ(high[4], 0x1234);
  EXPECT_EQ(high[5], 0x5678);
  EXPECT_EQ(high[6], 0x449a);  // 1234.5 is 0x449A5000
  EXPECT_EQ(high[7], 0x5000);
  const InputRegisters low = inputRegisters({}, {}, WordOrder::LowFirst);
  EXPECT_EQ(low[4], 0x5678);
  EXPECT_EQ(low[6], 0x5000);
}

TEST(RegisterMap, NamesTheJobThatStartWouldBegin) {
  PlcStatus status;
  EXPECT_EQ(inputRegisters(status, {}, WordOrder::HighFirst)[95], 0);
  status.job.next = 0x20001;
  EXPECT_EQ(inputRegisters(status, {}, WordOrder::HighFirst)[94], 2);
  EXPECT_EQ(inputRegisters(status, {}, WordOrder::HighFirst)[95], 1);
  EXPECT_EQ(inputRegisters(status, {}, WordOrder::LowFirst)[94], 1);
}

TEST(RegisterMap, SaysAbortedUntilTheUnitReportsItsState) {
  const InputRegisters registers = inputRegisters({}, {}, WordOrder::HighFirst);
  EXPECT_EQ(registers[10], 9) << "PackML's number of Aborted";
  EXPECT_EQ(registers[11], 9);
}

TEST(RegisterMap, ShowsTheUnitItsJobAndAlarms) {
  PlcStatus status;
  status.flags = {StatusFlag::Alarm, StatusFlag::ResumeWaits};
  status.state = UnitState::Held;
  status.state_requested = UnitState::Unholding;
  status.stop_reason = 3202;
  status.stop_value = -2;
  status.job.id = 70000;
  status.job.layer = -1;
  status.job.name = "a";
  ActiveAlarm hold;
  hold.id = 3202;
  hold.category = AlarmCategory::Hold;
  hold.value = 20.4;
  ActiveAlarm warning;
  warning.id = 8003;
  warning.category = AlarmCategory::Warning;
  status.alarms = {warning, hold};
  status.process.bed_c = 1.0F;
  status.counters.parts = 3;
  status.utc_s = 65536.25;
  status.is_clock_synchronised = true;
  const InputRegisters found = inputRegisters(status, {}, WordOrder::HighFirst);
  EXPECT_EQ(found[3], 0x8020);
  EXPECT_EQ(found[8], 1);
  EXPECT_EQ(found[10], 11);
  EXPECT_EQ(found[11], 12);
  EXPECT_EQ(found[15], 3202);
  EXPECT_EQ(found[16], 0xffff);
  EXPECT_EQ(found[17], 0xfffe);
  EXPECT_EQ(found[18], 1);
  EXPECT_EQ(found[19], 1);
  EXPECT_EQ(found[20], 3202);
  EXPECT_EQ(found[21], 20);
  EXPECT_EQ(found[22], 0);
  EXPECT_EQ(found[40], 1);
  EXPECT_EQ(found[41], 4464);
  EXPECT_EQ(found[45], 0xffff);
  EXPECT_EQ(found[52], 0xffff);
  EXPECT_EQ(found[53], 0xffff);
  EXPECT_EQ(found[62], 0x3f80);
  EXPECT_EQ(found[81], 3);
  EXPECT_EQ(found[90], 1);
  EXPECT_EQ(found[91], 0);
  EXPECT_EQ(found[92], 250);
  EXPECT_EQ(found[93], 1);
  EXPECT_EQ(found[100], 0x6100);
}

TEST(RegisterMap, CutsNamesBetweenCharacters) {
  PlcStatus status;
  status.job.name = std::string(63, 'x') + "\xc3\xa9";  // the last is two bytes, of which one would fit
  const InputRegisters found = inputRegisters(status, {}, WordOrder::HighFirst);
  EXPECT_EQ(found[131], 0x7800);
}

TEST(RegisterMap, ReadsWhatThePlcWrites) {
  HoldingRegisters written{};
  written[5] = 1;
  written[6] = 2;
  written[8] = 0b0101;
  written[9] = 0b10;
  written[10] = 0b100;
  written[11] = 0b1010;
  written[12] = 0x3f40;  // 0.75
  written[20] = 0x4142;
  written[21] = 0x4300;
  const PlcInputs found = plcInputs(written, WordOrder::HighFirst);
  EXPECT_EQ(found.job, 65538U);
  EXPECT_TRUE(found.has_material && found.has_cooling && !found.has_gas && !found.has_vacuum);
  EXPECT_TRUE(found.is_starved && !found.is_blocked);
  EXPECT_TRUE(found.is_emergency_stop_pressed && !found.is_guard_closed);
  EXPECT_TRUE(found.is_plate_clamped && found.is_zone_taken && !found.is_plate_there &&
              !found.is_part_removed);
  EXPECT_DOUBLE_EQ(found.speed, 0.75);
  EXPECT_EQ(found.badge, "ABC");
  EXPECT_DOUBLE_EQ(plcInputs({}, WordOrder::HighFirst).speed, 1.0);
}

TEST(PlcLink, AnswersOutsideTheMapWithAnException) {
  PlcLink link = openLink();
  EXPECT_EQ(exceptionOf(link.answer(1, reading(ModbusFunction::ReadInput, 8, 124), 0.0)), 0);
  EXPECT_EQ(exceptionOf(link.answer(1, reading(ModbusFunction::ReadInput, 8, 125), 0.0)), 2);
  EXPECT_EQ(exceptionOf(link.answer(1, reading(ModbusFunction::ReadHolding, 36, 1), 0.0)), 2);
  EXPECT_EQ(exceptionOf(link.answer(1, reading(ModbusFunction::ReadHolding, 65535, 125), 0.0)), 2);
  EXPECT_EQ(exceptionOf(link.answer(1, writing(14, {1, 2}), 0.0)), 2) << "15 is not for writing";
  EXPECT_EQ(exceptionOf(link.answer(1, writing(12, {0x3f00, 0}), 0.0)), 0) << "0.5";
  EXPECT_EQ(exceptionOf(link.answer(1, writing(12, {0x4000, 0}), 0.0)), 3) << "2.0";
  EXPECT_DOUBLE_EQ(link.inputs().speed, 0.5) << "what is refused changes nothing";
}

TEST(PlcLink, TakesACommandOnceWhenItsSequenceChanges) {
  PlcLink link = openLink();
  const auto command = [&](std::uint16_t number, std::uint16_t sequence) {
    link.answer(1, writing(1, {number, sequence}), 0.0);
    return link.takeOrders();
  };
  ASSERT_EQ(command(2, 5).size(), 1U);
  EXPECT_TRUE(command(2, 5).empty()) << "a repeated sequence does nothing";
  EXPECT_TRUE(command(3, 5).empty())
      << "nothing follows from a register that changes while its sequence stays";
  EXPECT_TRUE(command(3, 0).empty());
  const std::vector<PlcOrder> orders = command(3, 6);
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].value, 3U);
  link.setResult(orders[0], CommandResult::NotInThisState);
  const InputRegisters found = link.registers(0.0);
  EXPECT_EQ(found[12], 3);
  EXPECT_EQ(found[13], 6);
  EXPECT_EQ(found[14], 2);
  EXPECT_EQ(found[3] & 0b100, 0b100) << "refused";
}

TEST(PlcLink, TakesNothingThatMayBeLeftOverFromTheLinkBefore) {
  PlcLink link = startedLink();
  link.answer(1, writing(0, {9, 5, 50, 2, 3, 0, 77, 4}), 0.0);
  link.answer(1, writing(14, {3202}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty());
  const InputRegisters found = link.registers(0.0);
  EXPECT_EQ(found[12], 5);
  EXPECT_EQ(found[13], 50);
  EXPECT_EQ(found[14], 10) << "stale";
  link.answer(1, writing(14, {0}), 0.0);
  link.answer(1, writing(14, {3202}), 0.0);
  link.answer(1, writing(0, {10, 5, 51, 2, 4, 0, 77, 5}), 0.0);
  const std::vector<PlcOrder> orders = link.takeOrders();
  ASSERT_EQ(orders.size(), 4U);
  EXPECT_EQ(orders[0].kind, PlcOrder::Kind::Acknowledge);
  EXPECT_EQ(orders[1].sequence, 4);
  EXPECT_EQ(orders[2].sequence, 5);
  EXPECT_EQ(orders[3].sequence, 51);
}

TEST(PlcLink, TakesAStopThatIsWrittenAloneFromItsStartOn) {
  PlcLink link = startedLink();
  link.answer(1, writing(0, {1, 3, 50}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty()) << "with more, it may be left over";
  PlcLink another = startedLink();
  another.answer(1, writing(1, {3, 50}), 0.0);
  EXPECT_EQ(another.takeOrders().size(), 1U);
}

TEST(PlcLink, AnswersByItselfWhatCannotBeFollowed) {
  PlcLink link{PlcLinkSettings{}};
  link.setPresence(UnitPresence::Present, 0.0);
  clearOrders(link);
  link.answer(1, writing(1, {2, 1}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty());
  EXPECT_EQ(link.registers(0.0)[14], 4) << "remote access is locked";
  link.answer(1, writing(1, {8, 2}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U) << "what stops is always taken";
  link.setRemoteAccess(RemoteAccess::Allowed);
  link.answer(1, writing(1, {11, 3}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty());
  EXPECT_EQ(link.registers(0.0)[14], 8) << "no such command";
}

TEST(PlcLink, OrdersModeJobAndAcknowledgement) {
  PlcLink link = openLink();
  link.answer(1, writing(3, {2, 1, 0, 77, 1}), 0.0);
  link.answer(1, writing(14, {3202}), 0.0);
  const std::vector<PlcOrder> orders = link.takeOrders();
  ASSERT_EQ(orders.size(), 3U);
  EXPECT_EQ(orders[0].kind, PlcOrder::Kind::Mode);
  EXPECT_EQ(orders[1].kind, PlcOrder::Kind::Job);
  EXPECT_EQ(orders[1].value, 77U);
  EXPECT_EQ(orders[2].kind, PlcOrder::Kind::Acknowledge);
  EXPECT_EQ(orders[2].value, 3202U);
}

TEST(PlcLink, HasNewsWhenThePlcsSurroundingsChange) {
  PlcLink link = openLink();
  link.answer(1, writing(0, {1, 3, 9}), 0.0);
  EXPECT_EQ(link.news(), 0U) << "heartbeat and command are none";
  EXPECT_FALSE(link.isPlateWritten());
  link.answer(1, writing(11, {0}), 0.0);
  EXPECT_EQ(link.news(), 1U) << "that it was written at all";
  EXPECT_TRUE(link.isPlateWritten());
  link.answer(1, writing(11, {3}), 0.0);
  EXPECT_EQ(link.news(), 2U);
  link.answer(1, writing(11, {3}), 0.0);
  EXPECT_EQ(link.news(), 2U);
  link.answer(1, writing(35, {0x4100}), 0.0);
  EXPECT_EQ(link.news(), 3U);
}

TEST(PlcLink, LetsOneConnectionWrite) {
  PlcLink link = openLink();
  EXPECT_EQ(exceptionOf(link.answer(1, writing(0, {1}), 0.0)), 0);
  EXPECT_EQ(exceptionOf(link.answer(2, writing(0, {2}), 0.0)), 6);
  EXPECT_EQ(exceptionOf(link.answer(2, reading(ModbusFunction::ReadHolding, 0, 1), 0.0)), 0);
  EXPECT_EQ(exceptionOf(link.answer(2, writing(1, {2, 7}), 0.0)), 6) << "Start";
  EXPECT_EQ(exceptionOf(link.answer(2, writing(1, {4, 7, 1}), 0.0)), 6) << "Hold and more";
  EXPECT_EQ(exceptionOf(link.answer(2, writing(1, {4, 7}), 0.0)), 0) << "Hold alone is taken from anybody";
  EXPECT_EQ(link.takeOrders().size(), 1U);
  EXPECT_EQ(exceptionOf(link.answer(2, writing(0, {2}), 0.0)), 6) << "it does not become the writer by that";
  link.close(1);
  EXPECT_EQ(exceptionOf(link.answer(2, writing(0, {2}), 0.0)), 0);
}

TEST(PlcLink, LeavesThePlcItsRegistersWhereAnotherStops) {
  PlcLink link = startedLink();
  EXPECT_EQ(exceptionOf(link.answer(2, writing(1, {3, 7}), 0.0)), 0) << "Stop, before anybody writes";
  EXPECT_EQ(link.takeOrders().size(), 1U);
  EXPECT_EQ(link.registers(0.0)[14], 0) << "not answered yet";
  EXPECT_EQ(exceptionOf(link.answer(1, writing(0, {1, 5, 50}), 0.0)), 0) << "who stopped does not write";
  EXPECT_EQ(link.registers(0.0)[14], 10) << "nor does its Stop make the PLC's first command count";
  link.answer(1, writing(0, {2, 5, 51}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U);
  link.answer(2, writing(1, {4, 8}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U);
  link.answer(1, writing(0, {3, 5, 51}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty()) << "what a PLC writes each cycle does not undo the Hold of another";
  link.answer(2, writing(1, {4, 8}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty()) << "once";
  link.close(2);
  link.answer(2, writing(1, {4, 8}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U) << "another connection counts for itself";
}

TEST(PlcLink, TakesAStopOnceThatAPlcRepeatsAsTheOneThatWrites) {
  PlcLink link = startedLink();
  link.answer(1, writing(1, {3, 7}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U);
  link.answer(1, writing(0, {1}), 0.0);
  link.answer(1, writing(1, {3, 7}), 0.0);
  EXPECT_TRUE(link.takeOrders().empty());
  link.answer(1, writing(1, {1, 8}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U) << "Reset, which is another command";
}

TEST(PlcLink, TakesAStopAgainOnceThePlcHasLetItGo) {
  PlcLink link = startedLink();
  link.answer(1, writing(1, {3, 1}), 0.0);
  EXPECT_EQ(link.takeOrders().size(), 1U) << "before anybody writes";
  for (int press = 0; press < 2; ++press) {
    EXPECT_EQ(exceptionOf(link.answer(1, writing(1, {0, 0}), 0.0)), 0);
    EXPECT_TRUE(link.takeOrders().empty());
    link.answer(1, writing(1, {3, 1}), 0.0);
    EXPECT_EQ(link.takeOrders().size(), 1U) << "as the one that writes, by the same sequence, " << press;
    link.answer(1, writing(1, {3, 1}), 0.0);
    EXPECT_TRUE(link.takeOrders().empty()) << "held down, " << press;
  }
}

TEST(PlcLink, TakesAStopAgainOnceAPanelHasLetItGo) {
  PlcLink link = openLink();
  const auto isTaken = [&](std::uint16_t command, std::uint16_t sequence) {
    link.answer(2, writing(1, {command, sequence}), 0.0);
    return link.takeOrders().size() == 1;
  };
  EXPECT_TRUE(isTaken(3, 1));
  EXPECT_EQ(exceptionOf(link.answer(2, writing(1, {0, 0}), 0.0)), 6) << "the PLC writes, not the panel";
  EXPECT_TRUE(isTaken(3, 1));
  EXPECT_FALSE(isTaken(3, 1)) << "held down";
  EXPECT_EQ(exceptionOf(link.answer(2, writing(2, {0}), 0.0)), 6) << "the sequence alone";
  EXPECT_TRUE(isTaken(3, 1));
  EXPECT_EQ(exceptionOf(link.answer(2, writing(1, {0}), 0.0)), 6) << "the command alone lets nothing go";
  EXPECT_FALSE(isTaken(3, 1));
  EXPECT_FALSE(isTaken(1, 2)) << "Reset, refused";
  EXPECT_TRUE(isTaken(3, 1));
}

TEST(PlcLink, WatchesTheHeartbeatOnceItHasComeWithAccess) {
  PlcLink link{PlcLinkSettings{}};
  clearOrders(link);
  link.answer(1, writing(0, {1}), 0.0);
  EXPECT_EQ(link.watch(100.0), PlcHeartbeat::Unarmed);
  link.setRemoteAccess(RemoteAccess::Allowed);
  link.answer(1, writing(0, {2}), 100.0);
  EXPECT_TRUE(link.isAlive());
  EXPECT_EQ(link.watch(102.0), PlcHeartbeat::Good);
  EXPECT_EQ(link.watch(102.1), PlcHeartbeat::Lost);
  EXPECT_FALSE(link.isAlive());
  EXPECT_EQ(exceptionOf(link.answer(2, writing(8, {15}), 102.25)), 0)
      << "a new connection of a PLC that was cut off";
  link.close(2);
  link.answer(1, writing(1, {2, 9}), 102.3);
  EXPECT_TRUE(link.takeOrders().empty());
  EXPECT_EQ(link.registers(102.3)[14], 9);
  link.answer(1, writing(0, {2}), 103.0);
  EXPECT_EQ(link.watch(103.0), PlcHeartbeat::Lost) << "the same heartbeat is none";
  link.answer(1, writing(0, {3}), 104.0);
  EXPECT_EQ(link.watch(104.0), PlcHeartbeat::Good);
  EXPECT_EQ(link.watch(106.1), PlcHeartbeat::Lost);
  EXPECT_EQ(link.watch(404.0), PlcHeartbeat::Lost);
  EXPECT_EQ(link.watch(404.1), PlcHeartbeat::Abandoned);
}

TEST(PlcLink, HearsAHeartbeatWhetherOrNotItIsArmed) {
  PlcLink link{PlcLinkSettings{}};
  EXPECT_FALSE(link.isBeating(0.0));
  clearOrders(link);
  EXPECT_FALSE(link.isBeating(0.0)) << "it has written, but not its heartbeat";
  link.answer(1, writing(0, {1}), 10.0);
  EXPECT_TRUE(link.isBeating(12.0));
  EXPECT_FALSE(link.isBeating(12.1));
  EXPECT_FALSE(link.isAlive()) << "remote access is locked";
  link.answer(1, writing(0, {1}), 13.0);
  EXPECT_FALSE(link.isBeating(13.0)) << "the same heartbeat is none";
  link.answer(1, writing(0, {2}), 14.0);
  EXPECT_TRUE(link.isBeating(14.0));
}

TEST(PlcLink, StandsStillWhileTheUnitIsLost) {
  PlcLink link = openLink();
  EXPECT_EQ(link.registers(10.0)[1], 20);
  link.setPresence(UnitPresence::Lost, 11.0);
  link.setPresence(UnitPresence::Lost, 12.0);
  EXPECT_EQ(link.registers(20.0)[1], 22);
  link.answer(1, writing(1, {2, 1}), 20.0);
  EXPECT_TRUE(link.takeOrders().empty());
  EXPECT_EQ(link.registers(20.0)[14], 7) << "busy";
  link.answer(1, writing(1, {4, 2}), 20.0);
  EXPECT_EQ(link.takeOrders().size(), 1U) << "Hold is tried even where nobody may take it";
}

TEST(PlcLink, BeatsTwiceASecond) {
  const PlcLink link = openLink();
  EXPECT_EQ(link.registers(10.0)[1], 20);
  EXPECT_EQ(link.registers(10.5)[1], 21);
  EXPECT_EQ(link.registers(32768.0)[1], 0);
}

TEST(PlcLink, WritesBeforeItReadsInOneRequest) {
  PlcLink link = openLink();
  ModbusRequest request = writing(0, {42});
  request.function = ModbusFunction::ReadWrite;
  request.read_address = 0;
  request.read_count = 1;
  EXPECT_EQ(valuesOf(link.answer(1, request, 0.0)), (std::vector<std::uint16_t>{42}));
}

}  // namespace
}  // namespace lamina
