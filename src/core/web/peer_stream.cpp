// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "web/peer_stream.hpp"

#include <fcntl.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kLongestEnd = 120.0;       // [s] of a client that still sends, as the slowest upload takes
constexpr double kLongestEndSilence = 1.0;  // [s]

}  // namespace

TlsContext tlsContext(const std::string& certificate, const std::string& key) {
  TlsContext context(SSL_CTX_new(TLS_server_method()));
  if (!context) throw FileError("OpenSSL gives no context for TLS");
  SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
  SSL_CTX_set_options(context.get(),
                      SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION | SSL_OP_CIPHER_SERVER_PREFERENCE);
  SSL_CTX_set_mode(context.get(), SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  // Of TLS 1.2 only what keeps past traffic secret when the key is lost.
  SSL_CTX_set_cipher_list(context.get(), "ECDHE+AESGCM:ECDHE+CHACHA20");
  if (SSL_CTX_use_certificate_chain_file(context.get(), certificate.c_str()) != 1)
    throw FileError(certificate + ": cannot be used as a certificate; expected PEM");
  if (SSL_CTX_use_PrivateKey_file(context.get(), key.c_str(), SSL_FILETYPE_PEM) != 1 ||
      SSL_CTX_check_private_key(context.get()) != 1)
    throw FileError(key + ": is not the private key of " + certificate);
  return context;
}

PeerSocket::PeerSocket(int descriptor, SSL_CTX* context)
    : descriptor_(descriptor), is_plain_(context == nullptr) {
  ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) | O_NONBLOCK);
  const int is_on = 1;
  ::setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &is_on, sizeof is_on);
  if (is_plain_) return;
  ssl_.reset(SSL_new(context));
  if (ssl_) SSL_set_fd(ssl_.get(), descriptor_);
}

PeerSocket::~PeerSocket() {
  ssl_.reset();
  ::close(descriptor_);
}

void PeerSocket::allow(double seconds) { until_s_ = clock_.now() + seconds; }

double PeerSocket::left() const { return until_s_ - clock_.now(); }

bool PeerSocket::wait(short events, double seconds) const {
  pollfd poll{descriptor_, events, 0};
  return ::poll(&poll, 1, static_cast<int>(std::ceil(std::max(0.0, seconds) * 1000.0))) > 0;
}

/// Waits for what OpenSSL waits for.
PeerResult PeerSocket::await(int ssl_result) {
  const int reason = SSL_get_error(ssl_.get(), ssl_result);
  ERR_clear_error();
  if (reason != SSL_ERROR_WANT_READ && reason != SSL_ERROR_WANT_WRITE) return PeerResult::Closed;
  return wait(reason == SSL_ERROR_WANT_READ ? POLLIN : POLLOUT, left()) ? PeerResult::Done : PeerResult::Late;
}

PeerResult PeerSocket::shakeHands() {
  while (ssl_) {
    const int result = SSL_accept(ssl_.get());
    if (result == 1) return PeerResult::Done;
    const PeerResult awaited = await(result);
    if (awaited != PeerResult::Done) return awaited;
  }
  // Without memory for TLS there is none: what was meant to be encrypted is not sent in plain text.
  return is_plain_ ? PeerResult::Done : PeerResult::Closed;
}

PeerSocket::Transfer PeerSocket::read(void* buffer, std::size_t size) {
  while (true) {
    if (ssl_) {
      std::size_t bytes = 0;
      const int result = SSL_read_ex(ssl_.get(), buffer, size, &bytes);
      if (result == 1) return {PeerResult::Done, bytes};
      const PeerResult awaited = await(result);
      if (awaited != PeerResult::Done) return {awaited, 0};
      continue;
    }
    const ssize_t bytes = ::recv(descriptor_, buffer, size, 0);
    if (bytes > 0) return {PeerResult::Done, static_cast<std::size_t>(bytes)};
    if (bytes == 0) return {PeerResult::Closed, 0};
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return {PeerResult::Closed, 0};
    if (!wait(POLLIN, left())) return {PeerResult::Late, 0};
  }
}

PeerSocket::Transfer PeerSocket::write(const void* bytes, std::size_t size) {
  while (true) {
    if (ssl_) {
      std::size_t written = 0;
      const int result = SSL_write_ex(ssl_.get(), bytes, size, &written);
      if (result == 1) return {PeerResult::Done, written};
      const PeerResult awaited = await(result);
      if (awaited != PeerResult::Done) return {awaited, 0};
      continue;
    }
    const ssize_t written = ::send(descriptor_, bytes, size, MSG_NOSIGNAL);
    if (written >= 0) return {PeerResult::Done, static_cast<std::size_t>(written)};
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return {PeerResult::Closed, 0};
    if (!wait(POLLOUT, left())) return {PeerResult::Late, 0};
  }
}

bool PeerSocket::waitForBytes(double seconds) {
  if (ssl_ && SSL_pending(ssl_.get()) > 0) return true;
  return wait(POLLIN, seconds);
}

bool PeerSocket::waitForBytesBeside(int descriptor, double seconds) {
  if (ssl_ && SSL_pending(ssl_.get()) > 0) return true;
  std::array<pollfd, 2> polls{{{descriptor_, POLLIN, 0}, {descriptor, POLLIN, 0}}};
  ::poll(polls.data(), polls.size(), static_cast<int>(std::ceil(std::max(0.0, seconds) * 1000.0)));
  return polls[0].revents != 0;
}

std::size_t PeerSocket::unsent() const {
  int bytes = 0;
  return ::ioctl(descriptor_, SIOCOUTQ, &bytes) == 0 && bytes > 0 ? static_cast<std::size_t>(bytes) : 0;
}

void PeerSocket::close() {
  if (ssl_) SSL_shutdown(ssl_.get());
  ERR_clear_error();
  ::shutdown(descriptor_, SHUT_WR);
  // A reset would take the answer away that the other end has not read yet: many send all before they read.
  std::array<char, 16384> ignored{};
  const double until_s = clock_.now() + kLongestEnd;
  allow(kLongestEndSilence);
  while (clock_.now() < until_s) {
    const ssize_t bytes = ::recv(descriptor_, ignored.data(), ignored.size(), 0);
    if (bytes > 0)
      allow(kLongestEndSilence);
    else if (bytes == 0 || (errno != EINTR && errno != EAGAIN) || !wait(POLLIN, left()))
      return;
  }
}

}  // namespace lamina
