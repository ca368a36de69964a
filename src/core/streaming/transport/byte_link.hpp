// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <memory>
#include <string>
#include <utility>

#include "lamina/streaming/transport/transport.hpp"

namespace lamina {

/// Reads and writes an open stream of Asio: a socket, a serial port or a descriptor. Held by shared pointers,
/// as pending operations keep the link alive.
template <class Stream>
class ByteLink : public std::enable_shared_from_this<ByteLink<Stream>> {
 public:
  explicit ByteLink(Stream stream) : stream_(std::move(stream)) {}

  void start(TransportEvents events) {
    events_ = std::move(events);
    read();
  }

  void send(const std::string& bytes) {
    if (is_closed_ || bytes.empty()) return;
    waiting_ += bytes;
    if (writing_.empty()) write();
  }

  /// Number of bytes that the system has not accepted yet.
  std::size_t pending() const { return waiting_.size() + writing_.size(); }

  /// Closes the stream without a callback.
  void close() {
    is_closed_ = true;
    events_ = {};
    boost::system::error_code ignored;
    stream_.close(ignored);
  }

 private:
  void read() {
    stream_.async_read_some(
        boost::asio::buffer(read_),
        [self = this->shared_from_this()](const boost::system::error_code& error, std::size_t size) {
          if (self->is_closed_) return;
          if (error) {
            self->fail(error);
            return;
          }
          // Held here, since the receiver may close the link.
          const auto received = self->events_.received;
          received({self->read_.data(), size});
          if (!self->is_closed_) self->read();
        });
  }

  void write() {
    std::swap(writing_, waiting_);
    boost::asio::async_write(
        stream_, boost::asio::buffer(writing_),
        [self = this->shared_from_this()](const boost::system::error_code& error, std::size_t) {
          self->writing_.clear();
          if (self->is_closed_) return;
          if (error) {
            self->fail(error);
          } else if (!self->waiting_.empty()) {
            self->write();
          }
        });
  }

  void fail(const boost::system::error_code& error) {
    const auto closed = std::move(events_.closed);
    close();
    if (closed) closed(error.message());
  }

  Stream stream_;
  TransportEvents events_;
  std::array<char, 4096> read_{};
  std::string waiting_;
  std::string writing_;
  bool is_closed_ = false;
};

}  // namespace lamina
