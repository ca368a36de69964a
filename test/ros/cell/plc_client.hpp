// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <modbus/modbus.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamina::test {

using Registers = std::vector<std::uint16_t>;

/// A Modbus TCP client as PLCs and their programmers use them.
class PlcClient {
 public:
  virtual ~PlcClient() = default;
  virtual Registers inputs(int address, int count) = 0;
  virtual void write(int address, const Registers& values) = 0;

  std::uint16_t input(int address) { return inputs(address, 1).at(0); }
};

/// libmodbus, of which one connection stays open.
class LibmodbusClient final : public PlcClient {
 public:
  explicit LibmodbusClient(int port) : modbus_(modbus_new_tcp("127.0.0.1", port)) {
    modbus_set_slave(modbus_.get(), 1);
    modbus_set_response_timeout(modbus_.get(), 60, 0);
    if (modbus_connect(modbus_.get()) != 0) throw std::runtime_error(modbus_strerror(errno));
  }
  Registers inputs(int address, int count) override {
    Registers values(static_cast<std::size_t>(count));
    if (modbus_read_input_registers(modbus_.get(), address, count, values.data()) != count)
      throw std::runtime_error(modbus_strerror(errno));
    return values;
  }
  void write(int address, const Registers& values) override {
    const int count = static_cast<int>(values.size());
    if (modbus_write_registers(modbus_.get(), address, count, values.data()) != count)
      throw std::runtime_error(modbus_strerror(errno));
  }

 private:
  struct Free {
    void operator()(modbus_t* modbus) const {
      modbus_close(modbus);
      modbus_free(modbus);
    }
  };
  std::unique_ptr<modbus_t, Free> modbus_;
};

/// What a command prints.
inline std::string printedBy(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> piece{};
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe))
    text.append(piece.data(), count);
  if (pclose(pipe) != 0) throw std::runtime_error(command + " has failed: " + text);
  return text;
}

/// mbpoll: a process and a connection for each request.
class MbpollClient final : public PlcClient {
 public:
  explicit MbpollClient(int port) : common_("mbpoll -m tcp -0 -1 -q -a 1 -o 10 -p " + std::to_string(port)) {}
  Registers inputs(int address, int count) override {
    std::istringstream lines(printedBy(common_ + " -t 3 -r " + std::to_string(address) + " -c " +
                                       std::to_string(count) + " 127.0.0.1 2>&1"));
    Registers values;
    for (std::string line; std::getline(lines, line);) {
      const auto place = line.find("]:");
      if (place != std::string::npos)
        values.push_back(static_cast<std::uint16_t>(std::stoul(line.substr(place + 2))));
    }
    return values;
  }
  void write(int address, const Registers& values) override {
    std::string command = common_ + " -t 4 -r " + std::to_string(address) + " 127.0.0.1";
    for (const std::uint16_t value : values) command += ' ' + std::to_string(value);
    printedBy(command + " 2>&1");
  }

 private:
  std::string common_;
};

/// pymodbus, in a process that stays.
class PymodbusClient final : public PlcClient {
 public:
  PymodbusClient(int port, const std::string& script, const std::string& folder)
      : answers_path_(folder + "/pymodbus_answers") {
    std::remove(answers_path_.c_str());
    if (mkfifo(answers_path_.c_str(), 0600) != 0) throw std::runtime_error("cannot make " + answers_path_);
    pipe_ = popen(("/usr/bin/python3 " + script + ' ' + std::to_string(port) + " > " + answers_path_).c_str(),
                  "w");
    if (pipe_ == nullptr) throw std::runtime_error("cannot run " + script);
    answers_.open(answers_path_);
  }
  ~PymodbusClient() override { pclose(pipe_); }
  PymodbusClient(const PymodbusClient&) = delete;
  PymodbusClient& operator=(const PymodbusClient&) = delete;

  Registers inputs(int address, int count) override {
    return ask("read " + std::to_string(address) + ' ' + std::to_string(count));
  }
  void write(int address, const Registers& values) override {
    std::string request = "write " + std::to_string(address);
    for (const std::uint16_t value : values) request += ' ' + std::to_string(value);
    ask(request);
  }

 private:
  Registers ask(const std::string& request) {
    std::fputs((request + '\n').c_str(), pipe_);
    std::fflush(pipe_);
    std::string line;
    if (!std::getline(answers_, line) || line.compare(0, 2, "ok") != 0)
      throw std::runtime_error(request + " is answered '" + line + "'");
    std::istringstream numbers(line.substr(2));
    Registers values;
    for (int value = 0; numbers >> value;) values.push_back(static_cast<std::uint16_t>(value));
    return values;
  }

  std::string answers_path_;
  FILE* pipe_ = nullptr;
  std::ifstream answers_;
};

}  // namespace lamina::test
