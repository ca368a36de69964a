// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/exposure.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr const char* kPage = "see docs/cell/security.md";

std::string portOfMaster(const std::string& uri) {
  const std::size_t colon = uri.rfind(':');
  const std::string port = colon == std::string::npos ? "" : uri.substr(colon + 1);
  return port.substr(0, port.find('/'));
}

/// Whether the master listens on this host, and not on the loopback interface alone.
bool isMasterOpen(const Exposure& exposure) {
  const std::string host = hostOfMaster(exposure.master_uri);
  if (!isLoopbackHost(host) && host != exposure.host) return false;
  const std::string port = portOfMaster(exposure.master_uri);
  return std::any_of(exposure.all_ports.begin(), exposure.all_ports.end(),
                     [&](const ListeningPort& listening) {
                       return !listening.is_on_loopback && std::to_string(listening.port) == port;
                     });
}

std::string portsText(const std::vector<std::uint16_t>& ports) {
  std::string list;
  for (const std::uint16_t port : ports) list += (list.empty() ? "" : ", ") + std::to_string(port);
  return (ports.size() == 1 ? "port " : "ports ") + list;
}

}  // namespace

std::vector<std::string> exposureWarnings(const Exposure& exposure) {
  std::vector<std::string> warnings;
  if (!exposure.own_ports.empty())
    warnings.push_back(
        "whoever reaches this host commands this node: ROS has no authentication, and all interfaces lead "
        "to " +
        portsText(exposure.own_ports) + "; " + kPage);
  if (isMasterOpen(exposure))
    warnings.push_back(
        "whoever reaches this host commands every node: all interfaces lead to the ROS master's port " +
        portOfMaster(exposure.master_uri) + "; start it with ROS_IP=127.0.0.1, or " + kPage);
  const std::string master = hostOfMaster(exposure.master_uri);
  if (isLoopbackHost(exposure.host) && !isLoopbackHost(master))
    warnings.push_back("this node announces itself as " + exposure.host + " to the ROS master on " + master +
                       ", from where nobody reaches it; expected this host's address in ROS_IP");
  return warnings;
}

std::string hostOfMaster(const std::string& uri) {
  const std::size_t scheme = uri.find("://");
  const std::string authority = uri.substr(scheme == std::string::npos ? 0 : scheme + 3);
  if (authority.rfind('[', 0) == 0) return authority.substr(0, authority.find(']') + 1);
  return authority.substr(0, authority.find_first_of(":/"));
}

}  // namespace lamina
