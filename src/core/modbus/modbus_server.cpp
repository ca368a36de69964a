// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/modbus_server.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr int kIdleBeforeProbes = 5;           // [s]
constexpr int kProbeInterval = 2;              // [s]
constexpr int kProbes = 3;                     // without an answer: the peer is gone
constexpr unsigned int kUnansweredMs = 10000;  // of what was sent to it

/// A peer that lost its power closes nothing: without this its place would be taken for two hours.
void noticeDeath(int socket) {
  const int on = 1;
  setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &kIdleBeforeProbes, sizeof kIdleBeforeProbes);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPINTVL, &kProbeInterval, sizeof kProbeInterval);
  setsockopt(socket, IPPROTO_TCP, TCP_KEEPCNT, &kProbes, sizeof kProbes);
  setsockopt(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, &kUnansweredMs, sizeof kUnansweredMs);
}

/// Called once, with the reason if the peer did what it may not.
using Ended = std::function<void(int connection, const std::string& address, const std::string& fault)>;

/// One client: reads, answers what was read, and reads again.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(int number, tcp::socket socket, const ModbusPeers& peers, double half_frame_s, Ended ended)
      : number_(number),
        socket_(std::move(socket)),
        timer_(socket_.get_executor()),
        peers_(peers),
        half_frame_s_(half_frame_s),
        ended_(std::move(ended)) {
    error_code ignored;
    address_ = socket_.remote_endpoint(ignored).address().to_string(ignored);
    socket_.set_option(tcp::no_delay(true), ignored);
    noticeDeath(socket_.native_handle());
  }

  void read() {
    auto self = shared_from_this();
    socket_.async_read_some(asio::buffer(buffer_), [self](const error_code& error, std::size_t count) {
      if (error) return self->end("");
      self->heard_s_ = self->clock_.now();
      self->reader_.add(std::string_view(self->buffer_.data(), count), self->clock_.now());
      self->respond();
    });
  }

  const std::string& address() const { return address_; }
  double silentFor() const { return clock_.now() - heard_s_; }

  void end(const std::string& fault) {
    if (std::exchange(has_ended_, true)) return;
    error_code ignored;
    timer_.cancel(ignored);
    socket_.close(ignored);
    ended_(number_, address_, fault);
  }

 private:
  void respond() {
    out_.clear();
    std::string fault;
    while (const auto frame = reader_.next()) {
      if (const auto* request = std::get_if<ModbusRequest>(&*frame)) out_ += peers_.answer(number_, *request);
      if (const auto* refused = std::get_if<RefusedRequest>(&*frame)) out_ += modbusRefusal(*refused);
      if (const auto* broken = std::get_if<BrokenFrame>(&*frame)) fault = broken->reason;
    }
    if (!fault.empty()) return end(fault);
    watch();
    if (out_.empty()) return read();
    auto self = shared_from_this();
    asio::async_write(socket_, asio::buffer(out_), [self](const error_code& error, std::size_t) {
      if (error) return self->end("");
      self->read();
    });
  }

  /// Ends the connection when a frame that has begun does not come whole.
  void watch() {
    error_code ignored;
    timer_.cancel(ignored);
    const double waited_s = reader_.waited(clock_.now());
    if (!reader_.isWithin()) return;
    timer_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(std::max(0.0, half_frame_s_ - waited_s))));
    auto self = shared_from_this();
    timer_.async_wait([self](const error_code& error) {
      if (!error) self->end("half a frame, and no more in time");
    });
  }

  int number_;
  tcp::socket socket_;
  asio::steady_timer timer_;
  const ModbusPeers& peers_;
  double half_frame_s_;
  Ended ended_;
  SteadyClock clock_;
  double heard_s_ = clock_.now();
  std::string address_;
  FrameReader reader_;
  std::array<char, 4096> buffer_{};
  std::string out_;
  bool has_ended_ = false;
};

}  // namespace

class ModbusServer::Listener {
 public:
  Listener(ModbusServerSettings settings, ModbusPeers peers)
      : settings_(std::move(settings)), peers_(std::move(peers)), acceptor_(context_), pause_(context_) {
    open();
    accept();
    thread_ = std::thread([this] { context_.run(); });
  }

  ~Listener() {
    context_.stop();
    thread_.join();
  }

  std::uint16_t port() const { return port_; }

 private:
  void open() {
    try {
      const tcp::endpoint endpoint(asio::ip::make_address(settings_.bind), settings_.port);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw DeviceError("cannot listen on " + settings_.bind + ':' + std::to_string(settings_.port) + ": " +
                        error.code().message());
    }
  }

  void accept() {
    acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return acceptLater();
      if (isWelcome(socket)) {
        giveWay(socket);
        if (connections_.size() < settings_.connections) admit(std::move(socket));
      }
      accept();
    });
  }

  /// Where the host has no descriptors left, asking again at once would only take its time.
  void acceptLater() {
    pause_.expires_after(std::chrono::milliseconds(100));
    pause_.async_wait([this](const error_code& error) {
      if (!error) accept();
    });
  }

  bool isWelcome(const tcp::socket& socket) const {
    error_code error;
    const std::string address = socket.remote_endpoint(error).address().to_string(error);
    const auto& allowed = settings_.allow;
    return !error && std::find(allowed.begin(), allowed.end(), address) != allowed.end();
  }

  /// A device that comes back after a loss of power may find its own dead connections in all places: the one
  /// that has been silent for longest ends.
  void giveWay(const tcp::socket& socket) {
    if (connections_.size() < settings_.connections) return;
    error_code error;
    const std::string address = socket.remote_endpoint(error).address().to_string(error);
    std::shared_ptr<Connection> silent;
    for (const auto& [number, connection] : connections_)
      if (connection->address() == address && connection->silentFor() > settings_.replaceable_after_s &&
          (!silent || connection->silentFor() > silent->silentFor()))
        silent = connection;
    if (silent) silent->end("");
  }

  void admit(tcp::socket socket) {
    const int number = ++last_number_;
    const auto ended = [this](int gone, const std::string& address, const std::string& fault) {
      connections_.erase(gone);
      peers_.closed(gone);
      if (!fault.empty()) peers_.broken(address, fault);
    };
    const auto connection =
        std::make_shared<Connection>(number, std::move(socket), peers_, settings_.half_frame_s, ended);
    connections_[number] = connection;
    connection->read();
  }

  ModbusServerSettings settings_;
  ModbusPeers peers_;
  asio::io_context context_;
  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  std::uint16_t port_ = 0;
  int last_number_ = 0;
  std::map<int, std::shared_ptr<Connection>> connections_;
  std::thread thread_;
};

ModbusServer::ModbusServer(ModbusServerSettings settings, ModbusPeers peers)
    : listener_(std::make_unique<Listener>(std::move(settings), std::move(peers))) {}

ModbusServer::~ModbusServer() = default;

std::uint16_t ModbusServer::port() const { return listener_->port(); }

}  // namespace lamina
