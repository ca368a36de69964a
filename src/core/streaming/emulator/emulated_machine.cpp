// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_machine.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "streaming/transport/byte_link.hpp"
#include "streaming/transport/deadline_timer.hpp"

namespace lamina {

/// The machine's side of a raw pseudo-terminal. The other side is held open too, so that it outlives its
/// users.
class PseudoTerminal {
 public:
  /// @throws DeviceError if the system has none left
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  const std::string& path() const { return path_; }
  /// Hands over the machine's side, to be closed by the caller.
  int releaseMachineSide();

 private:
  int machine_ = -1;
  int user_ = -1;
  std::string path_;
};

/// A symbolic link that is removed with the object.
class SymbolicLink {
 public:
  explicit SymbolicLink(std::string path) : path_(std::move(path)) {}
  ~SymbolicLink();
  SymbolicLink(const SymbolicLink&) = delete;
  SymbolicLink& operator=(const SymbolicLink&) = delete;

  /// Makes the link, or makes it point elsewhere.
  /// @throws FileError if it cannot be made, or the path holds something that is no symbolic link
  void pointTo(const std::string& target);
  void remove();
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool is_made_ = false;
};

namespace {

void makeRaw(int descriptor) {
  struct termios options {};
  ::tcgetattr(descriptor, &options);
  ::cfmakeraw(&options);
  ::tcsetattr(descriptor, TCSANOW, &options);
}

using boost::asio::ip::tcp;
using PtyLink = ByteLink<boost::asio::posix::stream_descriptor>;
using TcpLink = ByteLink<tcp::socket>;

// Reports pile up where nobody reads them; real ports lose them too.
constexpr std::size_t kMostUnread = 1 << 16;

}  // namespace

PseudoTerminal::PseudoTerminal() {
  machine_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  char name[128] = {};
  const bool is_open = machine_ >= 0 && ::grantpt(machine_) == 0 && ::unlockpt(machine_) == 0 &&
                       ::ptsname_r(machine_, name, sizeof name) == 0;
  if (is_open) user_ = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (user_ < 0) {
    const std::string why = std::strerror(errno);
    if (machine_ >= 0) ::close(machine_);
    throw DeviceError("cannot open a pseudo-terminal: " + why);
  }
  path_ = name;
  makeRaw(user_);
}

PseudoTerminal::~PseudoTerminal() {
  if (machine_ >= 0) ::close(machine_);
  ::close(user_);
}

int PseudoTerminal::releaseMachineSide() {
  const int machine = machine_;
  machine_ = -1;
  return machine;
}

SymbolicLink::~SymbolicLink() { remove(); }

void SymbolicLink::remove() {
  if (is_made_) ::unlink(path_.c_str());
  is_made_ = false;
}

void SymbolicLink::pointTo(const std::string& target) {
  struct stat about {};
  if (::lstat(path_.c_str(), &about) == 0 && !S_ISLNK(about.st_mode)) {
    throw FileError("cannot link " + path_ + " to the pseudo-terminal: something else has that name");
  }
  // Made beside and renamed, so that the name never points to nothing.
  const std::string fresh = path_ + "." + std::to_string(::getpid());
  ::unlink(fresh.c_str());
  if (::symlink(target.c_str(), fresh.c_str()) != 0 || std::rename(fresh.c_str(), path_.c_str()) != 0) {
    throw FileError("cannot link " + path_ + " to the pseudo-terminal: " + std::strerror(errno));
  }
  is_made_ = true;
}

class EmulatedMachine::Impl {
 public:
  Impl(const EmulatedSettings& settings, std::vector<Fault> faults, const EmulatedPorts& ports,
       EmulatedObserver observer)
      : firmware_(settings, std::move(faults), std::move(observer)),
        replug_s_(settings.fault_replug_s),
        acceptor_(context_),
        work_timer_(context_, clock_, [this] { advance(); }),
        replug_timer_(context_, clock_, [this] { plugPty(); }) {
    if (!ports.pty_link.empty()) link_ = std::make_unique<SymbolicLink>(ports.pty_link);
    plugPty();
    if (ports.tcp_port) listen(*ports.tcp_port);
    firmware_.elapse(clock_.now());  // machine time starts here
    thread_ = std::thread([this] {
      const auto keep_running = boost::asio::make_work_guard(context_);
      context_.run();
    });
  }

  ~Impl() {
    boost::asio::post(context_, [this] { context_.stop(); });
    thread_.join();
    unplugPty();
    if (tcp_) tcp_->close();
  }

  std::string pty() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (link_) return link_->path();
    return terminal_ ? terminal_->path() : std::string();
  }
  std::uint16_t tcpPort() const { return tcp_port_; }

  /// What `ask` says of the firmware, from any thread.
  template <class Ask>
  auto query(Ask ask) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ask(firmware_);
  }

 private:
  enum class Speaker { Pty, Tcp };

  void listen(std::uint16_t port) {
    try {
      const tcp::endpoint endpoint(boost::asio::ip::address_v4::loopback(), port);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      tcp_port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw DeviceError("cannot listen on TCP port " + std::to_string(port) + ": " + error.code().message());
    }
    accept();
  }

  void accept() {
    acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
      if (error) return;
      socket.set_option(tcp::no_delay(true));
      if (tcp_) tcp_->close();
      tcp_ = std::make_shared<TcpLink>(std::move(socket));
      tcp_->start({[this](std::string_view bytes) { receive(bytes, Speaker::Tcp); }, {}});
      accept();
    });
  }

  void plugPty() {
    const std::lock_guard<std::mutex> lock(mutex_);
    terminal_ = std::make_unique<PseudoTerminal>();
    pty_ = std::make_shared<PtyLink>(
        boost::asio::posix::stream_descriptor(context_, terminal_->releaseMachineSide()));
    pty_->start({[this](std::string_view bytes) { receive(bytes, Speaker::Pty); }, {}});
    if (link_) link_->pointTo(terminal_->path());
  }

  void unplugPty() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (link_) link_->remove();
    if (pty_) pty_->close();
    terminal_.reset();
  }

  void receive(std::string_view bytes, Speaker speaker) {
    speaker_ = speaker;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      firmware_.receive(bytes, clock_.now());
    }
    passOn();
  }

  void advance() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      firmware_.elapse(clock_.now());
    }
    passOn();
  }

  /// Sends what the firmware has said and comes back when it wants to go on.
  void passOn() {
    if (firmware_.takeDisconnect()) {
      cutLink();
    } else {
      const std::string said = firmware_.takeOutput();
      if (speaker_ == Speaker::Pty && pty_->pending() < kMostUnread)
        pty_->send(said);
      else if (speaker_ == Speaker::Tcp && tcp_->pending() < kMostUnread)
        tcp_->send(said);
    }
    work_timer_.set(firmware_.nextDeadline());
  }

  void cutLink() {
    firmware_.takeOutput();
    if (speaker_ == Speaker::Tcp) {
      tcp_->close();
      return;
    }
    unplugPty();
    replug_timer_.set(clock_.now() + replug_s_);
  }

  SteadyClock clock_;
  boost::asio::io_context context_;
  mutable std::mutex mutex_;  ///< of the firmware and of the terminal's name, which other threads ask for
  EmulatedFirmware firmware_;
  double replug_s_;
  std::unique_ptr<SymbolicLink> link_;
  std::unique_ptr<PseudoTerminal> terminal_;
  std::shared_ptr<PtyLink> pty_;
  std::shared_ptr<TcpLink> tcp_;
  tcp::acceptor acceptor_;
  std::uint16_t tcp_port_ = 0;
  Speaker speaker_ = Speaker::Pty;
  DeadlineTimer work_timer_;
  DeadlineTimer replug_timer_;
  std::thread thread_;
};

EmulatedMachine::EmulatedMachine(const EmulatedSettings& settings, std::vector<Fault> faults,
                                 const EmulatedPorts& ports, EmulatedObserver observer)
    : impl_(std::make_unique<Impl>(settings, std::move(faults), ports, std::move(observer))) {}
EmulatedMachine::~EmulatedMachine() = default;

std::string EmulatedMachine::pty() const { return impl_->pty(); }
std::uint16_t EmulatedMachine::tcpPort() const { return impl_->tcpPort(); }
EmulatedCounts EmulatedMachine::counts() const {
  return impl_->query([](const EmulatedFirmware& firmware) { return firmware.counts(); });
}
bool EmulatedMachine::isIdle() const {
  return impl_->query([](const EmulatedFirmware& firmware) { return firmware.isIdle(); });
}
Point3 EmulatedMachine::position() const {
  return impl_->query([](const EmulatedFirmware& firmware) { return firmware.position(); });
}
double EmulatedMachine::nozzleTarget() const {
  return impl_->query([](const EmulatedFirmware& firmware) { return firmware.nozzleTarget(); });
}
double EmulatedMachine::bedTarget() const {
  return impl_->query([](const EmulatedFirmware& firmware) { return firmware.bedTarget(); });
}

}  // namespace lamina
