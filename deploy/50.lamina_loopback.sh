# Sourced by setup.sh. ROS has no authentication, so a master and nodes started from this shell are reached from this host
# alone, unless something says otherwise (docs/cell/security.md).
case "${ROS_MASTER_URI:-http://localhost:11311}" in
  http://localhost:* | http://127.*)
    if [ -z "${ROS_IP:-}${ROS_HOSTNAME:-}" ]; then export ROS_IP=127.0.0.1; fi ;;
esac
