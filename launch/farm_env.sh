#!/usr/bin/env bash
# Runs a command in the environment that nodes of this machine need to work for an evolver on another one:
#
#   ROS_MASTER_URI=http://evolverhost:11311 farm_env.sh roslaunch devo_evo simulators.launch
#
# farm.launch calls it on each machine, and simulators.sbatch in each job. ROS_IP becomes the address by which this machine
# reaches the master, if it is not set. DEVO_EVO_SETUP names the setup.bash to source, if it is not that of this package.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
found=""
for setup in "${DEVO_EVO_SETUP:-}" "$here/../build/devel/setup.bash" "$here/../../../setup.bash"; do
  if [ -r "$setup" ]; then
    set +u # catkin's set-up reads variables that need not be set
    master=${ROS_MASTER_URI:-}
    # shellcheck source=/dev/null
    source "$setup"
    export ROS_MASTER_URI=${master:-$ROS_MASTER_URI}
    set -u
    found=$setup
    break
  fi
done
if [ -z "$found" ]; then
  echo "farm_env.sh: no setup.bash of devo_evo beside $here; name it in DEVO_EVO_SETUP" >&2
  exit 1
fi

if [ -z "${ROS_IP:-}${ROS_HOSTNAME:-}" ]; then
  host=${ROS_MASTER_URI#http://}
  ROS_IP=$(/usr/bin/python3 -c '
import socket, sys
probe = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)  # sends nothing, but finds the way
probe.connect((sys.argv[1], 1))
print(probe.getsockname()[0])' "${host%%:*}") || {
    echo "farm_env.sh: cannot tell by which address this machine reaches $ROS_MASTER_URI; set ROS_IP" >&2
    exit 1
  }
  export ROS_IP
fi
exec "$@"
