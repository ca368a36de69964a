// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/background_reader.hpp"

#include <memory>
#include <utility>

namespace lamina {

void BackgroundReader::stop() {
  ++number_;
  is_cancelled_ = true;
  if (thread_.joinable()) thread_.join();
  is_cancelled_ = false;
}

void BackgroundReader::read(const std::string& path, Deliver deliver) {
  stop();
  thread_ = std::thread([this, path, deliver = std::move(deliver), number = number_] {
    const auto part = std::make_shared<DrawnPart>(drawProgram(path, frame_, is_cancelled_));
    const auto give = [this, part, deliver, number] {
      if (number == number_) deliver(std::move(*part));
    };
    QMetaObject::invokeMethod(&receiver_, give, Qt::QueuedConnection);
  });
}

}  // namespace lamina
