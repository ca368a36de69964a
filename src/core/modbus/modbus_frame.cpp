// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/modbus_frame.hpp"

#include <cstddef>

namespace lamina {
namespace {

constexpr std::size_t kHeader = 7;  // transaction, protocol, length, unit
constexpr std::size_t kMostRead = 125;
constexpr std::size_t kMostWritten = 123;
constexpr std::size_t kMostWrittenWithRead = 121;

std::uint8_t byteAt(std::string_view bytes, std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); }

std::uint16_t wordAt(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint16_t>((byteAt(bytes, at) << 8U) | byteAt(bytes, at + 1));
}

void appendWord(std::string& bytes, std::size_t word) {
  bytes += static_cast<char>((word >> 8U) & 0xffU);
  bytes += static_cast<char>(word & 0xffU);
}

std::string header(std::uint16_t transaction, std::uint8_t unit, std::size_t length) {
  std::string bytes;
  appendWord(bytes, transaction);
  appendWord(bytes, 0);
  appendWord(bytes, length + 1);
  bytes += static_cast<char>(unit);
  return bytes;
}

std::optional<std::string> headerFault(std::string_view bytes) {
  if (wordAt(bytes, 2) != 0) return "protocol " + std::to_string(wordAt(bytes, 2)) + "; expected 0";
  const std::uint16_t length = wordAt(bytes, 4);
  if (length < 2 || length > 254) return "length " + std::to_string(length) + "; expected 2 to 254";
  // The guide to Modbus over TCP has clients address a server itself by 255, or by 0.
  const std::uint8_t unit = byteAt(bytes, 6);
  if (unit != 0 && unit != 1 && unit != 255) return "unit " + std::to_string(unit) + "; expected 1, 0 or 255";
  return std::nullopt;
}

bool isKnown(std::uint8_t function) {
  return function == 3 || function == 4 || function == 6 || function == 16 || function == 23;
}

/// Bytes before the values of what a function writes; all of it for functions without values.
std::size_t fixedLength(ModbusFunction function) {
  switch (function) {
    case ModbusFunction::WriteMany:
      return 6;
    case ModbusFunction::ReadWrite:
      return 10;
    default:
      return 5;
  }
}

/// What the function and byte count of a request ask for; nothing if not even the byte count is there.
std::optional<std::size_t> expectedLength(ModbusFunction function, std::string_view body) {
  const std::size_t fixed = fixedLength(function);
  if (body.size() < fixed) return std::nullopt;
  const bool has_values = function == ModbusFunction::WriteMany || function == ModbusFunction::ReadWrite;
  return has_values ? fixed + byteAt(body, fixed - 1) : fixed;
}

std::vector<std::uint16_t> words(std::string_view bytes) {
  std::vector<std::uint16_t> words;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) words.push_back(wordAt(bytes, at));
  return words;
}

bool isAmount(std::size_t count, std::size_t most) { return count >= 1 && count <= most; }

/// @param body  function and what follows, of the expected length
ModbusFrame parsed(ModbusRequest request, std::string_view body) {
  const RefusedRequest bad_value = refused(request, ModbusException::IllegalValue);
  const std::uint16_t first = wordAt(body, 1);
  const std::uint16_t second = wordAt(body, 3);
  switch (request.function) {
    case ModbusFunction::ReadHolding:
    case ModbusFunction::ReadInput:
      if (!isAmount(second, kMostRead)) return bad_value;
      request.read_address = first;
      request.read_count = second;
      return request;
    case ModbusFunction::WriteOne:
      request.write_address = first;
      request.written = {second};
      return request;
    case ModbusFunction::WriteMany:
      if (!isAmount(second, kMostWritten) || byteAt(body, 5) != 2 * second) return bad_value;
      request.write_address = first;
      request.written = words(body.substr(6));
      return request;
    case ModbusFunction::ReadWrite: {
      const std::uint16_t count = wordAt(body, 7);
      if (!isAmount(second, kMostRead) || !isAmount(count, kMostWrittenWithRead) ||
          byteAt(body, 9) != 2 * count)
        return bad_value;
      request.read_address = first;
      request.read_count = second;
      request.write_address = wordAt(body, 5);
      request.written = words(body.substr(10));
      return request;
    }
  }
  return bad_value;
}

ModbusFrame frameOf(std::string_view bytes) {
  ModbusRequest request;
  request.transaction = wordAt(bytes, 0);
  request.unit = byteAt(bytes, 6);
  const std::string_view body = bytes.substr(kHeader);
  const std::uint8_t function = byteAt(body, 0);
  if (!isKnown(function))
    return RefusedRequest{request.transaction, request.unit, function, ModbusException::IllegalFunction};
  request.function = static_cast<ModbusFunction>(function);
  const auto expected = expectedLength(request.function, body);
  if (!expected || *expected != body.size())
    return BrokenFrame{"function " + std::to_string(function) + " with " + std::to_string(body.size()) +
                       " bytes; expected " +
                       std::to_string(expected.value_or(fixedLength(request.function)))};
  return parsed(std::move(request), body);
}

}  // namespace

void FrameReader::add(std::string_view bytes, double now_s) {
  if (is_broken_) return;
  if (bytes_.empty()) since_s_ = now_s;
  last_s_ = now_s;
  bytes_ += bytes;
}

std::optional<ModbusFrame> FrameReader::next() {
  if (is_broken_ || bytes_.size() < kHeader) return std::nullopt;
  if (const auto fault = headerFault(bytes_)) {
    is_broken_ = true;
    return BrokenFrame{*fault};
  }
  const std::size_t whole = kHeader - 1 + wordAt(bytes_, 4);
  if (bytes_.size() < whole) return std::nullopt;
  ModbusFrame frame = frameOf(std::string_view(bytes_).substr(0, whole));
  bytes_.erase(0, whole);
  since_s_ = last_s_;
  is_broken_ = std::holds_alternative<BrokenFrame>(frame);
  return frame;
}

double FrameReader::waited(double now_s) const { return bytes_.empty() ? 0.0 : now_s - since_s_; }

std::string modbusAnswer(const ModbusRequest& request, const std::vector<std::uint16_t>& read) {
  std::string body(1, static_cast<char>(request.function));
  if (request.read_count > 0) {
    body += static_cast<char>(2 * read.size());
    for (const std::uint16_t value : read) appendWord(body, value);
  } else {
    appendWord(body, request.write_address);
    appendWord(body, request.function == ModbusFunction::WriteOne ? request.written.front()
                                                                  : request.written.size());
  }
  return header(request.transaction, request.unit, body.size()) + body;
}

std::string modbusRefusal(const RefusedRequest& refused) {
  std::string body(1, static_cast<char>(refused.function | 0x80U));
  body += static_cast<char>(refused.exception);
  return header(refused.transaction, refused.unit, body.size()) + body;
}

RefusedRequest refused(const ModbusRequest& request, ModbusException exception) {
  return {request.transaction, request.unit, static_cast<std::uint8_t>(request.function), exception};
}

}  // namespace lamina
