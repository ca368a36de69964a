// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

namespace lamina {

class PrintContent;

/// The panel that slices and prints as RViz loads it: the content, saved and loaded with RViz's
/// configuration, and the camera led to what it shows.
class PrintPanel : public rviz::Panel {
 public:
  explicit PrintPanel(QWidget* parent = nullptr);

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  PrintContent* content_;
};

}  // namespace lamina
