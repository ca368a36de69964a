// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace lamina::test {

/// A device at the other end of a pseudo-terminal: what it is sent is given to a function that takes whole
/// messages from the front and answers them.
class TtyDevice {
 public:
  using Answer = std::function<std::string(std::string& received)>;

  explicit TtyDevice(Answer answer) : answer_(std::move(answer)), master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master_);
    ::unlockpt(master_);
    std::array<char, 64> name{};
    ::ptsname_r(master_, name.data(), name.size());
    path_ = name.data();
    // Held open, so that nothing is lost between two users of the other end.
    slave_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY);
    termios raw{};
    ::tcgetattr(slave_, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(slave_, TCSANOW, &raw);
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) std::abort();
    stop_read_ = ends[0];
    stop_write_ = ends[1];
    thread_ = std::thread([this] { run(); });
  }
  TtyDevice(const TtyDevice&) = delete;
  TtyDevice& operator=(const TtyDevice&) = delete;
  ~TtyDevice() {
    mute();
    for (const int each : {master_, slave_, stop_read_, stop_write_}) ::close(each);
  }

  const std::string& path() const { return path_; }

  /// It takes and answers nothing from now on.
  void mute() {
    if (!thread_.joinable()) return;
    if (::write(stop_write_, "x", 1) != 1) std::abort();
    thread_.join();
  }

 private:
  void run() {
    std::string received;
    for (;;) {
      std::array<pollfd, 2> ready = {{{master_, POLLIN, 0}, {stop_read_, POLLIN, 0}}};
      ::poll(ready.data(), ready.size(), -1);
      if (ready[1].revents != 0) return;
      std::array<char, 512> bytes{};
      const ssize_t count = ::read(master_, bytes.data(), bytes.size());
      if (count > 0) received.append(bytes.data(), static_cast<std::size_t>(count));
      const std::string answer = answer_(received);
      if (::write(master_, answer.data(), answer.size()) < 0) return;
    }
  }

  Answer answer_;
  int master_;
  int slave_ = -1;
  int stop_read_ = -1;
  int stop_write_ = -1;
  std::string path_;
  std::thread thread_;
};

/// Registers behind Modbus RTU, unit 1: functions 3, 16 and 23.
class RtuRegisters {
 public:
  std::string answer(std::string& received) {
    const auto byte = [&received](std::size_t i) { return static_cast<unsigned char>(received[i]); };
    const auto word = [&byte](std::size_t i) {
      return static_cast<std::uint16_t>(byte(i) << 8U | byte(i + 1));
    };
    if (received.size() < 8) return {};
    const unsigned function = byte(1);
    const std::size_t written = function == 16 ? 7U + byte(6) : received.size() > 10 ? 11U + byte(10) : 300U;
    const std::size_t length = 2 + (function == 3 ? 6U : written);
    if (received.size() < length) return {};
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t data = function == 16 ? 7 : 11;
    const std::size_t write_at = function == 16 ? word(2) : function == 23 ? word(6) : 0;
    for (std::size_t i = data; function != 3 && i + 2 < length; i += 2)
      registers_.at(write_at + (i - data) / 2) = word(i);
    std::string answer = received.substr(0, function == 16 ? 6 : 2);
    if (function != 16) {
      const std::size_t count = word(4);
      answer += static_cast<char>(2 * count);
      for (std::size_t i = 0; i < count; ++i) {
        answer += static_cast<char>(registers_.at(word(2) + i) >> 8U);
        answer += static_cast<char>(registers_.at(word(2) + i) & 0xFFU);
      }
    }
    received.erase(0, length);
    const std::uint16_t crc = crcOf(answer);
    answer += static_cast<char>(crc & 0xFFU);
    answer += static_cast<char>(crc >> 8U);
    return answer;
  }
  std::uint16_t at(std::size_t address) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return registers_.at(address);
  }

 private:
  static std::uint16_t crcOf(const std::string& bytes) {
    unsigned crc = 0xFFFF;
    for (const char each : bytes) {
      crc ^= static_cast<unsigned char>(each);
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? (crc >> 1U) ^ 0xA001U : crc >> 1U;
    }
    return static_cast<std::uint16_t>(crc);
  }

  std::mutex mutex_;
  std::array<std::uint16_t, 128> registers_{};
};

}  // namespace lamina::test
