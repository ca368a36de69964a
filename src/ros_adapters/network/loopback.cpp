// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/loopback.hpp"

#include <linux/filter.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/network.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include "network/exposure.hpp"

namespace lamina {
namespace {

constexpr std::string_view kMasterArgument = "__master:=";

constexpr auto kHeader = static_cast<std::uint32_t>(SKF_NET_OFF);  // where a filter finds the network header
constexpr std::uint32_t kVersion4Source = kHeader + 12;
constexpr std::uint32_t kVersion6Source = kHeader + 8;
constexpr std::uint32_t kTake = 0xffffffff;
constexpr std::uint32_t kDrop = 0;

constexpr sock_filter load(std::uint16_t size, std::uint32_t offset) {
  return {static_cast<std::uint16_t>(BPF_LD | size | BPF_ABS), 0, 0, offset};
}
constexpr sock_filter jumpIfEqual(std::uint32_t value, std::uint8_t by, std::uint8_t else_by) {
  return {BPF_JMP | BPF_JEQ | BPF_K, by, else_by, value};
}
constexpr sock_filter answer(std::uint32_t bytes) { return {BPF_RET | BPF_K, 0, 0, bytes}; }

/// Packets from 127.0.0.0/8 and ::1 pass. From outside the kernel lets no such address in.
constexpr std::array<sock_filter, 17> kFromLoopback = {{
    load(BPF_B, kHeader),
    {BPF_ALU | BPF_RSH | BPF_K, 0, 0, 4},
    jumpIfEqual(6, 4, 0),
    load(BPF_B, kVersion4Source),
    jumpIfEqual(127, 0, 1),
    answer(kTake),
    answer(kDrop),
    load(BPF_W, kVersion6Source),
    jumpIfEqual(0, 0, 7),
    load(BPF_W, kVersion6Source + 4),
    jumpIfEqual(0, 0, 5),
    load(BPF_W, kVersion6Source + 8),
    jumpIfEqual(0, 0, 3),
    load(BPF_W, kVersion6Source + 12),
    jumpIfEqual(1, 0, 1),
    answer(kTake),
    answer(kDrop),
}};

bool takesFilter(int descriptor) {
  auto program = kFromLoopback;
  const sock_fprog filter{static_cast<std::uint16_t>(program.size()), program.data()};
  return ::setsockopt(descriptor, SOL_SOCKET, SO_ATTACH_FILTER, &filter, sizeof filter) == 0;
}

std::string contentOf(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<ListeningPort> portsOfHost() {
  std::vector<ListeningPort> ports = listeningPorts(contentOf("/proc/net/tcp"));
  for (const ListeningPort& port : listeningPorts(contentOf("/proc/net/tcp6"))) ports.push_back(port);
  return ports;
}

struct OpenSocket {
  int descriptor;
  std::uint16_t port;
};

/// Listening sockets of this process that are not on the loopback interface.
std::vector<OpenSocket> openSockets() {
  std::vector<OpenSocket> sockets;
  const std::vector<ListeningPort> ports = portsOfHost();
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", unreadable)) {
    const std::string name = std::filesystem::read_symlink(entry.path(), unreadable).string();
    for (const ListeningPort& port : ports)
      if (!port.is_on_loopback && name == "socket:[" + std::to_string(port.inode) + "]")
        sockets.push_back({std::stoi(entry.path().filename()), port.port});
  }
  return sockets;
}

std::vector<std::uint16_t> portsOf(const std::vector<OpenSocket>& sockets) {
  std::vector<std::uint16_t> ports;
  ports.reserve(sockets.size());
  for (const OpenSocket& socket : sockets) ports.push_back(socket.port);
  return ports;
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string masterOf(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]).substr(0, kMasterArgument.size()) == kMasterArgument)
      return argv[i] + kMasterArgument.size();
  return environment("ROS_MASTER_URI");
}

}  // namespace

void stayOnLoopback(int argc, char** argv) {
  if (!environment("ROS_IP").empty() || !environment("ROS_HOSTNAME").empty()) return;
  const std::string master = masterOf(argc, argv);
  if (master.empty() || isLoopbackHost(hostOfMaster(master))) ::setenv("ROS_IP", "127.0.0.1", 1);
}

std::vector<std::uint16_t> closeToOtherHosts() {
  std::vector<OpenSocket> sockets = openSockets();
  sockets.erase(std::remove_if(sockets.begin(), sockets.end(),
                               [](const OpenSocket& socket) { return takesFilter(socket.descriptor); }),
                sockets.end());
  return portsOf(sockets);
}

void guardPorts() {
  const std::string& host = ros::network::getHost();
  const std::vector<std::uint16_t> open = isLoopbackHost(host) ? closeToOtherHosts() : portsOf(openSockets());
  for (const std::string& warning : exposureWarnings({host, ros::master::getURI(), open, portsOfHost()}))
    ROS_WARN_STREAM(warning);
}

}  // namespace lamina
