// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Messages of latched topics.
#pragma once

namespace lamina {

/// Publishes a message on a latched topic so that every subscriber gets it, also one that connects at that
/// moment. roscpp stores the message for later subscribers only after it was handed to the present ones, so
/// that a subscriber connecting in between would get none. If one connects then, all subscribers get the
/// message twice. Publisher is a latching ros::Publisher.
template <class Publisher, class Message>
void publishLatched(const Publisher& publisher, const Message& message) {
  const auto subscribers = publisher.getNumSubscribers();
  publisher.publish(message);
  if (publisher.getNumSubscribers() > subscribers) publisher.publish(message);
}

}  // namespace lamina
