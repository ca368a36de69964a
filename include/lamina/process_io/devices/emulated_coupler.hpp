// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lamina/base/clock.hpp"
#include "lamina/modbus/modbus_frame.hpp"
#include "lamina/modbus/modbus_server.hpp"
#include "lamina/process_io/devices/lagging_response.hpp"

namespace lamina {

/// Registers of the emulated coupler, from 0.
inline constexpr std::size_t kCouplerChannels = 16;
inline constexpr std::uint16_t kCouplerOutputs = 0;       ///< 16, written and read
inline constexpr std::uint16_t kCouplerEffects = 32;      ///< 16, read: what has become of the outputs
inline constexpr std::uint16_t kCouplerWatchdog = 64;     ///< [ms]; 0 for none
inline constexpr std::uint16_t kCouplerState = 65;        ///< read: 0 never written, 1 in service, 2 fault
inline constexpr std::uint16_t kCouplerReady = 66;        ///< read: 1 if the device behind it is ready
inline constexpr std::uint16_t kCouplerFaultValues = 80;  ///< 16, written and read
inline constexpr std::uint16_t kCouplerRegisters = 96;

struct CouplerSettings {
  double watchdog_s = 0.5;   ///< without a write to an output: then the fault values; 0 for none
  double dead_time_s = 0.0;  ///< of every output
  double lag_s = 0.0;        ///< the same
};

/// A change of an output.
struct CouplerEvent {
  enum class Cause : std::uint8_t { Written, Watchdog };
  double time_s = 0.0;
  std::size_t output = 0;
  std::uint16_t value = 0;
  Cause cause = Cause::Written;
};

/// A Modbus coupler with 16 outputs that is not there: registers, watchdog with fault values, effects that
/// lag, and a record of all that its outputs did. No network; times come from outside and must not go back.
class EmulatedCoupler {
 public:
  static constexpr std::size_t kMostEvents = 100000;  ///< that are kept: the first

  explicit EmulatedCoupler(const CouplerSettings& settings);

  /// The answer to a request, as bytes.
  std::string answer(const ModbusRequest& request, double now_s);
  /// Lets time pass: the watchdog looks.
  void advance(double now_s);

  std::uint16_t at(std::uint16_t address, double now_s);
  void setReady(bool is_ready) { is_ready_ = is_ready; }
  /// An output whose effect stays at 0, whatever it is sent.
  void block(std::size_t output) { is_blocked_.at(output) = true; }
  const std::vector<CouplerEvent>& events() const { return events_; }

 private:
  void set(std::size_t output, std::uint16_t value, double now_s, CouplerEvent::Cause cause);

  std::array<std::uint16_t, kCouplerChannels> outputs_{};
  std::array<std::uint16_t, kCouplerChannels> fault_values_{};
  std::array<bool, kCouplerChannels> is_blocked_{};
  std::vector<LaggingResponse> responses_;
  std::vector<CouplerEvent> events_;
  std::uint16_t watchdog_ms_;
  std::uint16_t state_ = 0;
  double written_s_ = 0.0;
  bool is_ready_ = true;
};

/// That coupler, for Modbus TCP clients, by the steady clock.
class CouplerServer {
 public:
  /// @throws DeviceError if it cannot listen there
  CouplerServer(const CouplerSettings& settings, const ModbusServerSettings& server);
  ~CouplerServer();

  std::uint16_t port() const { return server_->port(); }
  std::uint16_t at(std::uint16_t address);
  void setReady(bool is_ready);
  void block(std::size_t output);
  std::vector<CouplerEvent> events();

 private:
  SteadyClock clock_;
  std::mutex mutex_;
  EmulatedCoupler coupler_;
  std::unique_ptr<ModbusServer> server_;
};

}  // namespace lamina
