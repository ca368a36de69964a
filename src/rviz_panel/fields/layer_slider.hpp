// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>
#include <cstddef>
#include <functional>

class QLabel;
class QSlider;

namespace lamina {

/// A slider that says how many layers are shown, from the first on.
class LayerSlider : public QWidget {
 public:
  explicit LayerSlider(QWidget* parent);

  /// Another part, of which all layers are shown. Does not call `slid`.
  void setLayerCount(std::size_t layers);
  std::size_t shownLayers() const;
  /// As if somebody had moved it there.
  void slideTo(std::size_t layers);

  /// Somebody has moved it. On its way a fast slider does not call for every layer.
  std::function<void(std::size_t layers)> slid;

 private:
  QSlider* slider_;
  QLabel* label_;
  QTimer pause_;
};

}  // namespace lamina
