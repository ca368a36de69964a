// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph_look.hpp"

#include <netdb.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "peer_link.hpp"

namespace lamina {
namespace {

constexpr int kPatience = 1;                   // [s] for each step of an answer
constexpr std::size_t kLongestAnswer = 65536;  // [byte]

struct Endpoint {
  std::string host;
  std::string port;
};

/// Of "http://host:port/".
std::optional<Endpoint> endpointOf(const std::string& uri) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return std::nullopt;
  return Endpoint{host, std::to_string(port)};
}

/// A connection that gives up; -1 if there is none.
int connected(const Endpoint& endpoint) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (::getaddrinfo(endpoint.host.c_str(), endpoint.port.c_str(), &hints, &found) != 0) return -1;
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, &::freeaddrinfo);
  const int socket = ::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return -1;
  const timeval patience{kPatience, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (::connect(socket, found->ai_addr, found->ai_addrlen) == 0) return socket;
  ::close(socket);
  return -1;
}

/// All that comes until the other end closes, or nothing more comes.
std::string exchanged(int socket, const std::string& request) {
  std::string answer;
  if (::send(socket, request.data(), request.size(), MSG_NOSIGNAL) < 0) return answer;
  std::array<char, 4096> bytes{};
  while (answer.size() < kLongestAnswer && answer.find("</methodResponse>") == std::string::npos) {
    const ssize_t count = ::recv(socket, bytes.data(), bytes.size(), 0);
    if (count <= 0) break;
    answer.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return answer;
}

/// Calls a method of a master or node, of which each answers [code, text, value].
/// @return the value; nothing without an answer, or with another code than 1
std::optional<XmlRpc::XmlRpcValue> asked(const std::string& uri, const std::string& method,
                                         const std::vector<std::string>& arguments) {
  const auto endpoint = endpointOf(uri);
  const int socket = endpoint ? connected(*endpoint) : -1;
  if (socket < 0) return std::nullopt;
  std::string body = "<?xml version=\"1.0\"?><methodCall><methodName>" + method + "</methodName><params>";
  for (const std::string& argument : arguments)
    body += "<param><value><string>" + argument + "</string></value></param>";
  body += "</params></methodCall>";
  const std::string request = "POST / HTTP/1.0\r\nHost: " + endpoint->host +
                              "\r\nContent-Type: text/xml\r\nContent-length: " + std::to_string(body.size()) +
                              "\r\n\r\n" + body;
  const std::string answer = exchanged(socket, request);
  ::close(socket);
  const std::size_t begin = answer.find("<value>");
  if (begin == std::string::npos) return std::nullopt;
  int offset = static_cast<int>(begin);
  XmlRpc::XmlRpcValue value;
  if (!value.fromXml(answer, &offset) || value.getType() != XmlRpc::XmlRpcValue::TypeArray ||
      value.size() != 3 || value[0].getType() != XmlRpc::XmlRpcValue::TypeInt ||
      static_cast<int>(value[0]) != 1)
    return std::nullopt;
  return value[2];
}

std::optional<std::string> uriOf(const std::string& node) {
  const auto uri = asked(ros::master::getURI(), "lookupNode", {ros::this_node::getName(), node});
  if (!uri || uri->getType() != XmlRpc::XmlRpcValue::TypeString) return std::nullopt;
  XmlRpc::XmlRpcValue text = *uri;
  return static_cast<std::string>(text);
}

std::optional<int> pidOf(const std::string& uri) {
  const auto pid = asked(uri, "getPid", {ros::this_node::getName()});
  if (!pid || pid->getType() != XmlRpc::XmlRpcValue::TypeInt) return std::nullopt;
  XmlRpc::XmlRpcValue number = *pid;
  return static_cast<int>(number);
}

std::string defectOfMaster() {
  if (!asked(ros::master::getURI(), "getPid", {ros::this_node::getName()}))
    return "the ROS master at " + ros::master::getURI() + " does not answer";
  if (!uriOf(ros::this_node::getName()))
    return "the ROS master at " + ros::master::getURI() +
           " does not know this node: it was started anew, and the nodes have to be, too";
  return "";
}

}  // namespace

GraphLook::GraphLook(std::vector<std::string> nodes, double interval_s, HostWatch& watch, std::mutex& mutex)
    : nodes_(std::move(nodes)), interval_s_(interval_s), watch_(watch), mutex_(mutex), thread_([this] {
        run();
      }) {}

GraphLook::~GraphLook() {
  {
    const std::lock_guard<std::mutex> lock(ending_mutex_);
    is_ending_ = true;
  }
  ending_.notify_all();
  thread_.join();
}

void GraphLook::run() {
  std::unique_lock<std::mutex> lock(ending_mutex_);
  while (!is_ending_) {
    lock.unlock();
    look();
    lock.lock();
    ending_.wait_for(lock, std::chrono::duration<double>(interval_s_), [this] { return is_ending_; });
  }
}

void GraphLook::look() {
  const std::string defect = defectOfMaster();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    watch_.onMaster(defect, shiftedNow(0.0));
  }
  for (const std::string& node : nodes_) {
    const auto uri = uriOf(node);
    if (uri && defect.empty()) {
      // An answer of the master, too: the nodes that do not answer may keep the next look at it waiting.
      const std::lock_guard<std::mutex> lock(mutex_);
      watch_.onMaster("", shiftedNow(0.0));
    }
    const auto pid = uri ? pidOf(*uri) : std::nullopt;
    const std::lock_guard<std::mutex> lock(mutex_);
    watch_.onNode(node, pid);
  }
}

}  // namespace lamina
