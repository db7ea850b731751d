#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs every test through one ctest. Exits non-zero if any fails.
#
#   ./test.sh [ctest argument ...]   for example: ./test.sh -R Lattice
set -euo pipefail

repository=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
export BUILD_DIR=${BUILD_DIR:-$repository/build}
# Nodes talk to each other on this machine only, also where its host name does not resolve.
export ROS_HOSTNAME=localhost
unset ROS_IP

"$repository/scripts/install_packages"
"$repository/scripts/build" all tests
ctest --test-dir "$BUILD_DIR" --output-on-failure --parallel "$(nproc)" "$@" </dev/null
