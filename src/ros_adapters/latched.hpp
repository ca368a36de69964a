// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Messages of latched topics.
#pragma once

namespace lamina {

/// Publishes a message on a latched topic to every subscriber, also to one that connects during the call.
/// roscpp stores the message for later subscribers only after passing it to the present ones: a subscriber
/// that connects in between would get none. In this case all subscribers get the message twice. Publisher is
/// a latching ros::Publisher.
template <class Publisher, class Message>
void publishLatched(const Publisher& publisher, const Message& message) {
  const auto subscribers = publisher.getNumSubscribers();
  publisher.publish(message);
  if (publisher.getNumSubscribers() > subscribers) publisher.publish(message);
}

}  // namespace lamina
