#!/usr/bin/env python3
"""A ROS 2 node that renders a field: positions of a hand come in, forces go out. It needs rclpy and the Python module, and nothing else of isotouch.

    python3 ros2_node.py --ros-args -p field:=/home/me/scan.itf -p friction:=0.3

    subscribes   hand    geometry_msgs/PointStamped, m, in the frame of the workspace: x right, y up, z towards the person; one message is one tick
    publishes    force   geometry_msgs/WrenchStamped, N, on the hand, in the same frame
                 proxy   geometry_msgs/PointStamped, m
"""

from __future__ import annotations

# ROS 2 need not be installed to check this file.
# mypy: disable-error-code=import
import isotouch
import numpy as np
import rclpy
from geometry_msgs.msg import PointStamped, WrenchStamped
from rclpy.node import Node


class FieldNode(Node):  # type: ignore[misc]   # rclpy has no types
    def __init__(self) -> None:
        super().__init__("isotouch_field")
        path = self.declare_parameter("field", "").value
        friction = self.declare_parameter("friction", 0.0).value
        rate = self.declare_parameter("rate_hz", 1000.0).value
        with isotouch.Field.load(path) as field:
            self.touch = field.begin(isotouch.Settings(friction=friction, period_ns=round(1e9 / rate)))
            self.get_logger().info(f"{path}: {field.facts.samples} samples, {field.facts.stiffness_n_mm:.2f} N/mm")
        self.force = self.create_publisher(WrenchStamped, "force", 1)
        self.proxy = self.create_publisher(PointStamped, "proxy", 1)
        self.create_subscription(PointStamped, "hand", self.on_hand, 1)

    def on_hand(self, hand: PointStamped) -> None:
        """One tick. A position that is not finite gives no force, and a warning."""
        place = 1000 * np.array([hand.point.x, hand.point.y, hand.point.z])
        wrench, proxy = WrenchStamped(), PointStamped()
        wrench.header = proxy.header = hand.header
        try:
            felt = self.touch.position(place)
            wrench.wrench.force.x, wrench.wrench.force.y, wrench.wrench.force.z = map(float, felt["force_n"])
            proxy.point.x, proxy.point.y, proxy.point.z = map(float, felt["proxy_mm"] / 1000)
        except isotouch.ArgumentError as error:
            self.get_logger().warning(str(error))
            proxy.point = hand.point
        self.force.publish(wrench)
        self.proxy.publish(proxy)


def main() -> None:
    rclpy.init()
    node = FieldNode()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.touch.close()
        node.destroy_node()


if __name__ == "__main__":
    main()
