// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/former_port.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sys/socket.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <limits>
#include <string>

namespace lamina {

std::optional<std::uint16_t> formerPort() {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue answer;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = ros::this_node::getName();
  const bool is_known = ros::master::execute("lookupNode", request, answer, uri, false) &&
                        uri.getType() == XmlRpc::XmlRpcValue::TypeString;
  if (!is_known) return std::nullopt;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string&>(uri), host, port)) return std::nullopt;
  if (port == 0 || port > std::numeric_limits<std::uint16_t>::max()) return std::nullopt;
  return static_cast<std::uint16_t>(port);
}

HeldPort::HeldPort(std::uint16_t port) : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  place.sin_port = htons(port);
  // Connections of the dead may linger at the port; one that is listened to is given to nobody.
  const int on = 1;
  const bool is_held = descriptor_ >= 0 &&
                       ::setsockopt(descriptor_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
                       ::bind(descriptor_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 &&
                       ::listen(descriptor_, 1) == 0;
  if (is_held || descriptor_ < 0) return;
  ::close(descriptor_);
  descriptor_ = -1;
}

HeldPort::~HeldPort() {
  if (isHeld()) ::close(descriptor_);
}

}  // namespace lamina
