// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>
#include <QWidget>
#include <functional>
#include <stdexcept>

namespace lamina::test {

constexpr qint64 kPatienceMs = 60000;  // far above what anything takes, for loaded machines

/// The named part of a window.
template <class Widget>
Widget& part(const QWidget& window, const char* name) {
  auto* found = window.findChild<Widget*>(name);
  if (found == nullptr) throw std::runtime_error(std::string("the window has no part named ") + name);
  return *found;
}

/// Lets the window live until something is true.
/// @return false if it is not within `kPatienceMs`
inline bool waitFor(const std::function<bool()>& is_true) {
  QElapsedTimer clock;
  clock.start();
  while (!is_true() && clock.elapsed() < kPatienceMs) {
    QCoreApplication::processEvents();
    QThread::msleep(5);
  }
  return is_true();
}

}  // namespace lamina::test
