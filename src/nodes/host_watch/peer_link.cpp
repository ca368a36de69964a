// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peer_link.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <optional>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/utc_time.hpp"

namespace lamina {
namespace {

constexpr double kLongestAge = 1.0;  // [s] of a datagram in the kernel's queue

sockaddr_in addressOf(const std::string& address, int port) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(static_cast<std::uint16_t>(port));
  if (inet_pton(AF_INET, address.c_str(), &at.sin_addr) != 1)
    throw InvalidConfig("hosts.bind is " + address + "; expected an IPv4 address in figures");
  return at;
}

/// When the kernel received it, by the clock of the host.
std::optional<double> stampOf(msghdr& message) {
  for (cmsghdr* each = CMSG_FIRSTHDR(&message); each != nullptr; each = CMSG_NXTHDR(&message, each)) {
    if (each->cmsg_level != SOL_SOCKET || each->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec stamp{};
    std::memcpy(&stamp, CMSG_DATA(each), sizeof stamp);
    return static_cast<double>(stamp.tv_sec) + 1e-9 * static_cast<double>(stamp.tv_nsec);
  }
  return std::nullopt;
}

}  // namespace

CellTime shiftedNow(double shift_s) { return {SteadyClock().now(), utcNow() + shift_s}; }

PeerLink::PeerLink(const HostWatchNodeSettings& settings, HostWatch& watch, std::mutex& mutex)
    : watch_(watch), mutex_(mutex), interval_s_(settings.interval_s), shift_s_(settings.shift_s) {
  for (const PeerAddress& peer : peersOf(settings))
    peers_.push_back({peer.host.name, addressOf(peer.address, peer.port)});
  if (peers_.empty()) return;
  const sockaddr_in own = addressOf(settings.bind, settings.port);
  socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int is_stamped = 1;
  const bool is_bound =
      socket_ >= 0 &&
      ::setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &is_stamped, sizeof is_stamped) == 0 &&
      ::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
  if (!is_bound) {
    const std::string reason = std::strerror(errno);
    if (socket_ >= 0) ::close(socket_);
    throw DeviceError("UDP " + settings.bind + ":" + std::to_string(settings.port) +
                      " cannot be had: " + reason);
  }
  thread_ = std::thread([this] { run(); });
}

PeerLink::~PeerLink() {
  is_ending_ = true;
  if (thread_.joinable()) thread_.join();
  if (socket_ >= 0) ::close(socket_);
}

void PeerLink::run() {
  const SteadyClock clock;
  double next_s = clock.now();
  while (!is_ending_) {
    if (clock.now() >= next_s) {
      askAll();
      next_s = std::max(next_s + interval_s_, clock.now());
    }
    const double wait_s = std::max(0.0, next_s - clock.now());
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(wait_s * 1e3) + 1) > 0) receive();
  }
}

void PeerLink::askAll() {
  for (const Peer& peer : peers_) {
    HostDatagram question;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      question = watch_.ask(peer.name, shiftedNow(shift_s_));
    }
    send(peer, question);
  }
}

void PeerLink::receive() {
  std::array<char, 64> bytes{};
  std::array<char, 256> control{};
  sockaddr_in from{};
  iovec part{bytes.data(), bytes.size()};
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof from;
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t count = ::recvmsg(socket_, &message, MSG_DONTWAIT);
  if (count < 0) return;
  const CellTime now = shiftedNow(shift_s_);
  const double age_s = now.utc_s - shift_s_ - stampOf(message).value_or(now.utc_s - shift_s_);
  const auto datagram = hostDatagramIn({bytes.data(), static_cast<std::size_t>(count)});
  if (!datagram || age_s < 0.0 || age_s > kLongestAge) return;
  for (const Peer& peer : peers_)
    if (peer.address.sin_addr.s_addr == from.sin_addr.s_addr && peer.address.sin_port == from.sin_port)
      return hear(peer, *datagram, {now.steady_s - age_s, now.utc_s - age_s});
}

void PeerLink::hear(const Peer& peer, HostDatagram datagram, CellTime at) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (datagram.kind == HostDatagramKind::Answer) return watch_.onAnswer(peer.name, datagram, at);
    watch_.onQuestion(peer.name, at);
  }
  datagram.kind = HostDatagramKind::Answer;
  datagram.received_s = at.utc_s;
  datagram.answered_s = shiftedNow(shift_s_).utc_s;
  send(peer, datagram);
}

void PeerLink::send(const Peer& peer, const HostDatagram& datagram) const {
  const std::string bytes = encoded(datagram);
  // What cannot be sent, as on a cable that is pulled, is missed by the other host.
  static_cast<void>(::sendto(socket_, bytes.data(), bytes.size(), 0,
                             reinterpret_cast<const sockaddr*>(&peer.address), sizeof peer.address));
}

}  // namespace lamina
