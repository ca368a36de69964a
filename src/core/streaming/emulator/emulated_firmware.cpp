// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_firmware.hpp"

#include "streaming/emulator/firmware_board.hpp"

namespace lamina {

EmulatedFirmware::EmulatedFirmware(const EmulatedSettings& settings, std::vector<Fault> faults,
                                   EmulatedObserver observer)
    : board_(std::make_unique<Board>(settings, std::move(faults), std::move(observer))) {}
EmulatedFirmware::~EmulatedFirmware() = default;

void EmulatedFirmware::receive(std::string_view bytes, double wall_s) { board_->receive(bytes, wall_s); }
void EmulatedFirmware::elapse(double wall_s) { board_->elapse(wall_s); }
std::string EmulatedFirmware::takeOutput() { return board_->takeOutput(); }
double EmulatedFirmware::nextDeadline() const { return board_->nextDeadline(); }
bool EmulatedFirmware::takeDisconnect() { return board_->takeDisconnect(); }
bool EmulatedFirmware::isIdle() const { return board_->isIdle(); }
EmulatedCounts EmulatedFirmware::counts() const { return board_->counts(); }
Point3 EmulatedFirmware::position() const { return board_->position(); }
double EmulatedFirmware::nozzleTarget() const { return board_->heaters().nozzle.target(); }
double EmulatedFirmware::bedTarget() const { return board_->heaters().bed.target(); }

}  // namespace lamina
