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

/// Addresses of the registers of the emulated coupler, from 0.
inline constexpr std::size_t kCouplerChannels = 16;
inline constexpr std::uint16_t kCouplerOutputs = 0;  ///< 16 registers, written and read
/// 16 registers, read: effects of the outputs, after dead time and lag.
inline constexpr std::uint16_t kCouplerEffects = 32;
inline constexpr std::uint16_t kCouplerWatchdog = 64;     ///< [ms]; 0 for none
inline constexpr std::uint16_t kCouplerState = 65;        ///< read: 0 never written, 1 in service, 2 fault
inline constexpr std::uint16_t kCouplerReady = 66;        ///< read: 1 if the device behind it is ready
inline constexpr std::uint16_t kCouplerFaultValues = 80;  ///< 16 registers, written and read
inline constexpr std::uint16_t kCouplerRegisters = 96;

struct CouplerSettings {
  /// Time without a write to an output after which outputs take their fault values; 0 for none.
  double watchdog_s = 0.5;
  double dead_time_s = 0.0;  ///< dead time of every output
  double lag_s = 0.0;        ///< time constant of every output
};

/// A change of an output.
struct CouplerEvent {
  enum class Cause : std::uint8_t { Written, Watchdog };
  double time_s = 0.0;
  std::size_t output = 0;
  std::uint16_t value = 0;
  Cause cause = Cause::Written;
};

/// Emulates a Modbus coupler with 16 outputs: registers, a watchdog with fault values, effects that lag, and
/// a record of all changes of outputs. It has no network and no clock: callers pass times, which must not go
/// back.
class EmulatedCoupler {
 public:
  static constexpr std::size_t kMostEvents = 100000;  ///< number of events that are kept, the first ones

  explicit EmulatedCoupler(const CouplerSettings& settings);

  /// The answer to a request, as bytes.
  std::string answer(const ModbusRequest& request, double now_s);
  /// Advances to a time. If the watchdog has expired by then, outputs take their fault values.
  void advance(double now_s);

  /// The value of a register.
  std::uint16_t at(std::uint16_t address, double now_s);
  void setReady(bool is_ready) { is_ready_ = is_ready; }
  /// Makes the effect of an output stay at 0, whatever is sent.
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

/// Serves an `EmulatedCoupler` to Modbus TCP clients, by the steady clock.
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
