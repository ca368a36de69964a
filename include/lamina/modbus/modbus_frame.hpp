// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lamina {

// Frames of requests to a Modbus TCP server, and of its answers. Source: MODBUS Application Protocol 1.1b3;
// MODBUS Messaging on TCP/IP 1.0b; docs/cell/plc.md.

/// The functions that the server answers.
enum class ModbusFunction : std::uint8_t {
  ReadHolding = 3,
  ReadInput = 4,
  WriteOne = 6,
  WriteMany = 16,
  ReadWrite = 23,  ///< writes first, then reads
};

/// A well-formed request: its length fits its function and byte count.
struct ModbusRequest {
  std::uint16_t transaction = 0;
  std::uint8_t unit = 1;
  ModbusFunction function = ModbusFunction::ReadHolding;
  std::uint16_t read_address = 0;  ///< of the first register read
  std::uint16_t read_count = 0;    ///< 1 to 125; 0 if nothing is read
  std::uint16_t write_address = 0;
  std::vector<std::uint16_t> written;  ///< values of consecutive registers; empty if nothing is written
};

enum class ModbusException : std::uint8_t {
  IllegalFunction = 1,
  IllegalAddress = 2,
  IllegalValue = 3,
  ServerBusy = 6,
};

/// A frame that is only answered with an exception.
struct RefusedRequest {
  std::uint16_t transaction = 0;
  std::uint8_t unit = 1;
  std::uint8_t function = 0;  ///< number of the function as received
  ModbusException exception = ModbusException::IllegalFunction;
};

/// A frame after which the byte stream can no longer be split into frames: the connection has to be closed.
struct BrokenFrame {
  std::string reason;
};

using ModbusFrame = std::variant<ModbusRequest, RefusedRequest, BrokenFrame>;

/// Splits the bytes of a connection into frames as they arrive. The header of a frame states its length,
/// which must be the length that its function requires: a longer frame, in which a second one could hide, is
/// broken. So is a frame for another protocol, or for a unit other than 1 and 255. After a broken frame
/// nothing more is read.
class FrameReader {
 public:
  void add(std::string_view bytes, double now_s);

  /// The next whole frame; nothing if more bytes are needed.
  std::optional<ModbusFrame> next();

  /// True if a frame has begun that is not whole.
  bool isWithin() const { return !bytes_.empty(); }

  /// Time [s] for which the oldest byte of an incomplete frame has waited; 0 if there is none.
  double waited(double now_s) const;

 private:
  std::string bytes_;
  double since_s_ = 0.0;  ///< time of arrival of the first of the bytes
  double last_s_ = 0.0;   ///< time of arrival of the last of the bytes
  bool is_broken_ = false;
};

/// The answer to a request that was carried out.
/// @param read  values of the registers that it read, `read_count` of them
std::string modbusAnswer(const ModbusRequest& request, const std::vector<std::uint16_t>& read);

/// The answer that refuses a request.
std::string modbusRefusal(const RefusedRequest& refused);
RefusedRequest refused(const ModbusRequest& request, ModbusException exception);

}  // namespace lamina
