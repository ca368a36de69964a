// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/devices/emulated_coupler.hpp"

#include <cmath>
#include <utility>

namespace lamina {
namespace {

/// Whether a register lies among those of the channels from a first one on.
bool isAmong(std::uint16_t address, std::uint16_t first) {
  return address >= first && address < first + kCouplerChannels;
}

bool isWritableRegister(std::uint16_t address) {
  return isAmong(address, kCouplerOutputs) || isAmong(address, kCouplerFaultValues) ||
         address == kCouplerWatchdog;
}

/// Whether all registers of a request are there, and may be written where it does.
bool isWithin(const ModbusRequest& request) {
  if (request.read_address + request.read_count > kCouplerRegisters) return false;
  for (std::size_t i = 0; i < request.written.size(); ++i)
    if (request.write_address + i >= kCouplerRegisters ||
        !isWritableRegister(static_cast<std::uint16_t>(request.write_address + i)))
      return false;
  return true;
}

}  // namespace

EmulatedCoupler::EmulatedCoupler(const CouplerSettings& settings)
    : responses_(kCouplerChannels, LaggingResponse(settings.dead_time_s, settings.lag_s)),
      watchdog_ms_(static_cast<std::uint16_t>(std::lround(1e3 * settings.watchdog_s))) {}

std::string EmulatedCoupler::answer(const ModbusRequest& request, double now_s) {
  advance(now_s);
  if (!isWithin(request)) return modbusRefusal(refused(request, ModbusException::IllegalAddress));
  for (std::size_t i = 0; i < request.written.size(); ++i) {
    const auto address = static_cast<std::uint16_t>(request.write_address + i);
    if (isAmong(address, kCouplerFaultValues)) {
      fault_values_.at(address - kCouplerFaultValues) = request.written[i];
    } else if (address == kCouplerWatchdog) {
      watchdog_ms_ = request.written[i];
    } else {
      state_ = 1;
      written_s_ = now_s;
      set(address, request.written[i], now_s, CouplerEvent::Cause::Written);
    }
  }
  std::vector<std::uint16_t> read;
  for (std::uint16_t i = 0; i < request.read_count; ++i)
    read.push_back(at(static_cast<std::uint16_t>(request.read_address + i), now_s));
  return modbusAnswer(request, read);
}

void EmulatedCoupler::advance(double now_s) {
  const double watchdog_s = 1e-3 * watchdog_ms_;
  if (state_ != 1 || watchdog_ms_ == 0 || now_s - written_s_ < watchdog_s) return;
  state_ = 2;
  for (std::size_t i = 0; i < kCouplerChannels; ++i)
    set(i, fault_values_.at(i), written_s_ + watchdog_s, CouplerEvent::Cause::Watchdog);
}

std::uint16_t EmulatedCoupler::at(std::uint16_t address, double now_s) {
  advance(now_s);
  if (isAmong(address, kCouplerOutputs)) return outputs_.at(address);
  if (isAmong(address, kCouplerFaultValues)) return fault_values_.at(address - kCouplerFaultValues);
  if (isAmong(address, kCouplerEffects)) {
    const std::size_t output = address - kCouplerEffects;
    const double effect = responses_.at(output).effectAt(now_s);
    return is_blocked_.at(output) ? 0 : static_cast<std::uint16_t>(std::lround(effect));
  }
  if (address == kCouplerWatchdog) return watchdog_ms_;
  if (address == kCouplerState) return state_;
  return address == kCouplerReady && is_ready_ ? 1 : 0;
}

void EmulatedCoupler::set(std::size_t output, std::uint16_t value, double now_s, CouplerEvent::Cause cause) {
  if (std::exchange(outputs_.at(output), value) == value) return;
  responses_.at(output).send(value, now_s);
  if (events_.size() < kMostEvents) events_.push_back({now_s, output, value, cause});
}

CouplerServer::CouplerServer(const CouplerSettings& settings, const ModbusServerSettings& server)
    : coupler_(settings) {
  ModbusPeers peers;
  peers.answer = [this](int, const ModbusRequest& request) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return coupler_.answer(request, clock_.now());
  };
  peers.closed = [](int) {};
  peers.broken = [](const std::string&, const std::string&) {};
  server_ = std::make_unique<ModbusServer>(server, std::move(peers));
}

CouplerServer::~CouplerServer() = default;

std::uint16_t CouplerServer::at(std::uint16_t address) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return coupler_.at(address, clock_.now());
}

void CouplerServer::setReady(bool is_ready) {
  const std::lock_guard<std::mutex> lock(mutex_);
  coupler_.setReady(is_ready);
}

void CouplerServer::block(std::size_t output) {
  const std::lock_guard<std::mutex> lock(mutex_);
  coupler_.block(output);
}

std::vector<CouplerEvent> CouplerServer::events() {
  const std::lock_guard<std::mutex> lock(mutex_);
  coupler_.advance(clock_.now());
  return coupler_.events();
}

}  // namespace lamina
