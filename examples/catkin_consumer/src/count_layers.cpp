// Has slicing_service slice a part, and counts its layers by the core as well: rosrun lamina_consumer
// count_layers
#include <ros/ros.h>

#include <iostream>
#include <lamina/geometry/parts/parts.hpp>
#include <lamina/slicing/layer.hpp>
#include <lamina_ros/messages.hpp>

int main(int argc, char** argv) {
  ros::init(argc, argv, "count_layers");
  ros::NodeHandle node;
  ros::ServiceClient slicer = node.serviceClient<lamina_msgs::SliceMesh>("slice_mesh");
  lamina_msgs::SliceMesh slicing;
  slicing.request.part = "box";
  if (!slicer.waitForExistence(ros::Duration(20.0)) || !slicer.call(slicing)) return 1;

  const lamina::Box3 box = lamina::boundingBox(lamina::makePart("box"));
  const std::size_t expected = lamina::stackLayers(box.low.z(), box.high.z(), {}).size();
  std::cout << slicing.response.summary.layers << " layers by the node, " << expected << " by the core\n";
  return slicing.response.summary.layers == expected ? 0 : 1;
}
