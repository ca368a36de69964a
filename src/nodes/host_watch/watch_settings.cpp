// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "watch_settings.hpp"

#include <arpa/inet.h>
#include <ros/names.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

int portIn(const std::string& text, const std::string& key) {
  const bool is_number = !text.empty() && text.size() <= 5 &&
                         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int port = is_number ? std::stoi(text) : 0;
  if (port < 1 || port > 65535)
    throw InvalidConfig(key + " has the port '" + text + "'; expected 1 to 65535");
  return port;
}

}  // namespace

void describe(SettingsSchema& schema, HostWatchNodeSettings& settings) {
  HostWatchSettings& watch = settings.watch;
  schema.text("hosts.name", watch.host, "Name of this host in messages.");
  schema.text("hosts.bind", settings.bind,
              "IPv4 address of this host at which the others reach it; one that is not of the loopback "
              "interface opens a port to the network.");
  schema.integer("hosts.port", settings.port, {1, 65535}, "UDP port of this host.");
  schema.table("hosts.peers", settings.peers,
               "The other hosts, by name: IPv4 address, or address:port where the port is another one.");
  schema.text("hosts.needed", settings.needed,
              "Names of those without which no job runs, commas between; the loss of one is alarm 8001.");
  schema.number("hosts.silence_s", watch.silence_s, {0.5, 60.0},
                "Time without a word from another host, after which it is lost.");
  schema.number("hosts.interval_s", settings.interval_s, {0.02, 1.0},
                "Time between two questions to a host.");
  schema.number("clock.warn_s", watch.warn_offset_s, {0.0005, 10.0}, "Offset of clocks that is alarm 8003.");
  schema.number("clock.hold_s", watch.hold_offset_s, {0.001, 10.0},
                "Offset of clocks that is alarm 8004 where clocks are needed.");
  schema.flag("clock.is_needed", watch.is_clock_needed,
              "Whether jobs use stamps of another host, as a sensor's there.");
  schema.number("clock.shift_s", settings.shift_s, {-10.0, 10.0},
                "Time that is added to this host's clock in what is sent to the others, for trials.");
  schema.number("master.silence_s", watch.master_silence_s, {1.0, 600.0},
                "Time without a good answer of the ROS master, after which it is lost.");
  schema.text("disk.folder", settings.folder, "Folder whose disk is watched: that of the journal.");
  schema.number("disk.least_gib", settings.least_gib, {0.0, 1000.0},
                "Free space below which alarm 7002 is raised [GiB].");
  schema.text("nodes", settings.nodes,
              "Names of the nodes that are watched, in the watch's own namespace or full, commas between.");
  schema.text(
      "guard.socket", settings.guard_socket,
      "Socket for the streamer or driver of a machine on this host, which is stopped in its place if it dies "
      "or hangs at work; empty for none.");
  schema.number(
      "guard.silence_s", settings.guard.silence_s, {0.2, 60.0},
      "Time without a pulse of a process that still lives, after which it is lost, and ended before "
      "the machine is stopped.");
  schema.number(
      "guard.grace_s", settings.guard.grace_s, {0.0, 600.0},
      "Time from the loss of a streamer at work until the machine is stopped; 0 for at once, as always "
      "after that of a driver.");
  schema.number(
      "guard.unattended_s", settings.guard.unattended_s, {0.0, 86400.0},
      "Time for which a streamer that came back may leave the machine as the lost one left it; 0 for "
      "any time.");
}

HostWatchSettings watchOf(const HostWatchNodeSettings& settings) {
  constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
  HostWatchSettings watch = settings.watch;
  watch.least_free_bytes = settings.least_gib * kGibibyte;
  return watch;
}

std::vector<std::string> watchedNodes(const HostWatchNodeSettings& settings, const std::string& space) {
  std::vector<std::string> nodes = listEntries(settings.nodes);
  for (std::string& node : nodes) {
    std::string defect;
    if (!ros::names::validate(node, defect))
      throw InvalidConfig("nodes is '" + settings.nodes + "': " + defect);
    node = ros::names::resolve(space, node);
  }
  return nodes;
}

std::vector<PeerAddress> peersOf(const HostWatchNodeSettings& settings) {
  const std::vector<std::string> needed = listEntries(settings.needed);
  for (const std::string& name : needed)
    if (settings.peers.count(name) == 0)
      throw InvalidConfig("hosts.needed is " + settings.needed + ", but hosts.peers has no " + name);
  std::vector<PeerAddress> peers;
  for (const auto& [name, place] : settings.peers) {
    const std::size_t colon = place.find(':');
    PeerAddress peer;
    peer.host = {name, std::find(needed.begin(), needed.end(), name) != needed.end()};
    peer.address = place.substr(0, colon);
    peer.port =
        colon == std::string::npos ? settings.port : portIn(place.substr(colon + 1), "hosts.peers." + name);
    in_addr parsed{};
    if (inet_pton(AF_INET, peer.address.c_str(), &parsed) != 1)
      throw InvalidConfig("hosts.peers." + name + " is " + place + "; expected an IPv4 address in figures");
    peers.push_back(peer);
  }
  return peers;
}

}  // namespace lamina
