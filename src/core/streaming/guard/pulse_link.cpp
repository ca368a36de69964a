// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/pulse_link.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "base/threads/thread_priority.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::chrono::milliseconds kPeriod{50};
constexpr std::size_t kMostConnections = 8;
constexpr double kLongestWait = 60.0;  // s

/// @throws InvalidInput if it is too long
sockaddr_un placeOf(const std::string& path) {
  sockaddr_un place{};
  place.sun_family = AF_UNIX;
  if (path.size() >= sizeof place.sun_path)
    throw InvalidInput("the socket " + path + " has " + std::to_string(path.size()) +
                       " bytes; expected at most " + std::to_string(sizeof place.sun_path - 1));
  std::memcpy(place.sun_path, path.c_str(), path.size());
  return place;
}

const sockaddr* addressOf(const sockaddr_un& place) { return reinterpret_cast<const sockaddr*>(&place); }

/// -1 if nobody listens.
int connectedTo(const sockaddr_un& place) {
  const int socket = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket < 0 || ::connect(socket, addressOf(place), sizeof place) == 0) return socket;
  ::close(socket);
  return -1;
}

/// The process at the other end, if it is of this user or of root; 0 if not.
int processAt(int socket) {
  ucred other{};
  socklen_t size = sizeof other;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &other, &size) != 0) return 0;
  return other.uid == ::getuid() || other.uid == 0 ? other.pid : 0;
}

}  // namespace

class PulseSender::Impl {
 public:
  Impl(const std::string& socket, std::function<MachinePulse()> pulse)
      : place_(placeOf(socket)), pulse_(std::move(pulse)), thread_([this] { run(); }) {}
  ~Impl() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
    if (socket_ >= 0) ::close(socket_);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool isHeard() const { return is_heard_; }
  void send() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_due_ = true;
    }
    changed_.notify_all();
  }

 private:
  void run() {
    preferThisThread();
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_ending_) {
      is_due_ = false;
      lock.unlock();
      beat();
      lock.lock();
      changed_.wait_for(lock, kPeriod, [this] { return is_ending_ || is_due_; });
    }
    lock.unlock();
    beat();  // the last word: that it ends at rest
  }

  void beat() {
    if (socket_ < 0) socket_ = connectedTo(place_);
    if (socket_ < 0) return;
    const std::string text = toText(pulse_());
    // A listener that is busy for a while has the beats before this one to read.
    const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    is_heard_ = sent >= 0 || errno == EAGAIN;
    if (is_heard_) return;
    ::close(std::exchange(socket_, -1));
  }

  sockaddr_un place_;
  std::function<MachinePulse()> pulse_;
  std::mutex mutex_;  ///< of the two below
  bool is_ending_ = false;
  bool is_due_ = false;
  std::condition_variable changed_;
  std::atomic<bool> is_heard_{false};
  int socket_ = -1;  ///< of the thread
  std::thread thread_;
};

PulseSender::PulseSender(const std::string& socket, std::function<MachinePulse()> pulse) {
  if (!socket.empty()) impl_ = std::make_unique<Impl>(socket, std::move(pulse));
}
PulseSender::~PulseSender() = default;
bool PulseSender::isHeard() const { return !impl_ || impl_->isHeard(); }
void PulseSender::send() {
  if (impl_) impl_->send();
}

class PulseListener::Impl {
 public:
  explicit Impl(std::string socket) : path_(std::move(socket)), place_(placeOf(path_)) {
    const int other = connectedTo(place_);
    if (other >= 0) {
      ::close(other);
      throw DeviceError("the socket " + path_ + " is listened to by another process");
    }
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), ignored);
    ::unlink(path_.c_str());  // of a process that was killed
    socket_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const bool is_there = socket_ >= 0 && ::bind(socket_, addressOf(place_), sizeof place_) == 0 &&
                          ::chmod(path_.c_str(), S_IRUSR | S_IWUSR) == 0 &&
                          ::listen(socket_, static_cast<int>(kMostConnections)) == 0;
    wake_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (is_there && wake_ >= 0) return;
    const std::string reason = std::strerror(errno);
    close();
    throw DeviceError("the socket " + path_ + " cannot be made: " + reason);
  }
  ~Impl() {
    ::unlink(path_.c_str());
    close();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  std::vector<HeardPulse> wait(double timeout_s) {
    std::vector<pollfd> waiting = {{wake_, POLLIN, 0}, {socket_, POLLIN, 0}};
    for (const Connection& each : connections_) waiting.push_back({each.socket, POLLIN, 0});
    const double wait_s = std::clamp(timeout_s, 0.0, kLongestWait);
    ::poll(waiting.data(), waiting.size(), static_cast<int>(std::ceil(wait_s * 1e3)));
    if (waiting[0].revents != 0) forgetWake();
    std::vector<HeardPulse> heard;
    // Ends first: who comes in the place of another is heard after it.
    for (std::size_t i = 0; i < connections_.size(); ++i)
      if (waiting[i + 2].revents != 0) read(connections_[i], heard);
    connections_.erase(std::remove_if(connections_.begin(), connections_.end(),
                                      [](const Connection& each) { return each.socket < 0; }),
                       connections_.end());
    if (waiting[1].revents != 0) accept();
    return heard;
  }

  void wake() const {
    const std::uint64_t one = 1;
    static_cast<void>(!::write(wake_, &one, sizeof one));
  }

 private:
  struct Connection {
    int socket = -1;
    int process = 0;
  };

  void forgetWake() const {
    std::uint64_t count = 0;
    static_cast<void>(!::read(wake_, &count, sizeof count));
  }

  /// All that waits: of many beats the last one counts.
  static void read(Connection& connection, std::vector<HeardPulse>& heard) {
    std::array<char, kLongestPulse + 1> bytes{};
    std::optional<MachinePulse> last;
    bool has_ended = false;
    for (ssize_t count = 0; !has_ended;) {
      count = ::recv(connection.socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (count < 0 && (errno == EAGAIN || errno == EINTR)) break;
      auto pulse = count <= 0 ? std::nullopt : pulseIn({bytes.data(), static_cast<std::size_t>(count)});
      has_ended = !pulse;
      if (pulse) last = std::move(pulse);
    }
    if (last) heard.push_back({connection.process, std::move(last)});
    if (!has_ended) return;
    heard.push_back({connection.process, std::nullopt});
    ::close(std::exchange(connection.socket, -1));
  }

  void accept() {
    const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (socket < 0) return;
    const int process = processAt(socket);
    if (process == 0 || connections_.size() == kMostConnections)
      ::close(socket);
    else
      connections_.push_back({socket, process});
  }

  void close() {
    for (const Connection& each : connections_) ::close(each.socket);
    if (socket_ >= 0) ::close(socket_);
    if (wake_ >= 0) ::close(wake_);
  }

  std::string path_;
  sockaddr_un place_;
  int socket_ = -1;
  int wake_ = -1;
  std::vector<Connection> connections_;
};

PulseListener::PulseListener(std::string socket) : impl_(std::make_unique<Impl>(std::move(socket))) {}
PulseListener::~PulseListener() = default;
std::vector<HeardPulse> PulseListener::wait(double timeout_s) { return impl_->wait(timeout_s); }
void PulseListener::wake() { impl_->wake(); }

}  // namespace lamina
