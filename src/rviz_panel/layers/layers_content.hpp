// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "drawing/shown_layers.hpp"
#include "lamina/picture/frame_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "messages.hpp"

class QDoubleSpinBox;
class QLabel;

namespace lamina {

class LayerSlider;

/// What is in the panel of layers, in any window: the layers of the last toolpath and, if asked for, the
/// nozzle's frames along them. ROS must have been started.
///
/// Subscribes `toolpath` (lamina/Toolpath)
/// Publishes `shown_layers` (visualization_msgs/MarkerArray): what changes, and to newcomers everything
class LayersContent : public QWidget {
 public:
  explicit LayersContent(QWidget* parent);
  ~LayersContent() override;

  FrameSettings frames() const;
  void setFrames(const FrameSettings& settings);

  std::function<void()> changed;  ///< which frames are shown

 private:
  void take(const lamina_msgs::ToolpathConstPtr& message);
  void draw();

  LayerSlider* slider_;
  QDoubleSpinBox* every_;
  QDoubleSpinBox* length_;
  QLabel* part_;
  QTimer poll_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  Toolpath toolpath_;
  ShownLayers shown_;
};

}  // namespace lamina
