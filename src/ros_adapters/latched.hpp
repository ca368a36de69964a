// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Messages of latched topics.
#pragma once

namespace lamina {

/// Publishes a message of a latched topic for every subscriber, also for one that connects in the same
/// moment: roscpp keeps the message for later ones only after it was handed to those that were there, and one
/// in between gets none. Where one does, all of them get it twice. Publisher is a ros::Publisher that
/// latches.
template <class Publisher, class Message>
void publishLatched(const Publisher& publisher, const Message& message) {
  const auto subscribers = publisher.getNumSubscribers();
  publisher.publish(message);
  if (publisher.getNumSubscribers() > subscribers) publisher.publish(message);
}

}  // namespace lamina
