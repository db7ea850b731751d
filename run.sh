#!/usr/bin/env bash
# Installs what is missing, builds, and runs an experiment: ./run.sh --help.
set -euo pipefail

repository=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
export BUILD_DIR=${BUILD_DIR:-$repository/build}

usage()
{
  cat <<'END'
Usage: ./run.sh [argument:=value ...]

Installs the Debian packages that are missing, builds, and runs an experiment by
    roslaunch devo_evo experiment.launch [argument:=value ...]
on a ROS master of its own, which only this machine can reach. Ctrl-C stops it;
the same command goes on where it stopped.

Arguments and their defaults:
    body:=soft                     soft | rigid: the quadruped of Fig S5
    treatment:=evo_devo            evo | evo_devo
    profile:=paper                 paper | released_code
    trials:=1                      independent trials, side by side
    generations:=20                generations after the founders
    population:=30                 robots that survive a generation
    seed:=1                        of all randomness
    mutation_rate:=self_adaptive   self_adaptive | a number from 0 to 1
    lifetime:=10                   seconds from birth to the end
    grid:=4x4x3                    voxels along x, y and z
    simulators:=0                  simulators on this machine; 0: one a core
    founders:=                     file of robots that every trial starts with
    output:=                       folder of the results; without one,
                                   ~/devo_evo/<treatment>-...-seed-<seed>
    rviz:=false                    true: rviz shows the best robot so far
    record:=false                  true: everything goes to a bag in output
    config:=                       YAML file with any parameter; these arguments
                                   go before it (config/experiment.yaml)
    ns:=devo_evo                   namespace of nodes, topics and services
Folders and files may be relative to where you are. README.md says more.

Exit status: 0 if the experiment finished or was told to stop, 2 for a wrong
argument, 130 after Ctrl-C, 143 after SIGTERM, anything else if it failed.

To use a ROS master that is up already, source build/devel/setup.bash and call
roslaunch yourself.
END
}

fail()
{
  echo "run.sh: $*" >&2
  exit 2
}

# Sets `arguments` to those of roslaunch. It would ignore names that it does not know, and look for relative paths in
# ~/.ros, so names are checked here, and paths made absolute.
read_arguments()
{
  local argument name known given=" "
  known=" $(usage | sed -n 's/^    \([a-z_]*\):=.*/\1/p' | tr '\n' ' ')"
  arguments=()
  for argument in "$@"; do
    name=${argument%%:=*}
    case "$argument" in
      -h | --help) usage; exit 0 ;;
      [a-z]*:=*) ;;
      *) fail "'$argument' is not argument:=value; ./run.sh --help lists the arguments" ;;
    esac
    [[ $known == *" $name "* ]] || fail "there is no argument '$name'; there are$known"
    [[ $given != *" $name "* ]] || fail "'$name' is given twice"
    given+="$name "
    case "$argument" in
      output:=[!/]* | config:=[!/]* | founders:=[!/]*) argument="$name:=$PWD/${argument#*:=}" ;;
    esac
    arguments+=("$argument")
  done
}

# Sets `port` to one that no ROS master uses. The lock, held while we and our nodes live, keeps another run.sh off it.
choose_port()
{
  for port in {11311..11410}; do
    exec {port_lock}>"$BUILD_DIR/.port-$port"
    if flock --nonblock "$port_lock" && ! (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; then
      return
    fi
    exec {port_lock}>&-
  done
  fail "the ports from 11311 to 11410, of which the ROS master needs one, are all in use"
}

# Says what nodes are to preload to listen on this machine only (src/nodes/loopback.cpp).
keep_to_loopback()
{
  local library
  library=$(readlink -f "$BUILD_DIR")/devel/lib/libdevo_evo_loopback.so
  if [[ $library == *[:\ ]* ]]; then
    echo "run.sh: a space or colon in the path of the build folder: other machines can reach the nodes' XML-RPC ports" >&2
  elif [ -e "$library" ]; then # not in builds with a sanitizer
    echo "$library"
  fi
}

# Copies standard error, but for roslaunch's alarm when the evolver, which it requires, has done its work and ends.
pass_on_errors()
{
  trap '' INT TERM HUP # the nodes still have something to say after that
  exec sed -u '/REQUIRED process/ { N; /finished cleanly/ { N; N; N; d } }' >&2
}

# Passes a signal on to roslaunch, if it has been started, as the one that it and its nodes end well on.
interrupt()
{
  interrupted=$1
  [ -z "$child" ] || kill -INT "$child" 2>/dev/null || true
}

# Runs roslaunch and waits until it has stopped its nodes.
launch()
{
  local interrupted=0 child="" launched=0
  trap 'interrupt 130' INT
  trap 'interrupt 143' TERM
  trap 'interrupt 129' HUP
  set -m # a process group of its own, so that Ctrl-C reaches it through the trap alone
  LD_PRELOAD=$preload${LD_PRELOAD:+:$LD_PRELOAD} \
    roslaunch --port "$port" --no-summary --disable-title devo_evo experiment.launch "${arguments[@]}" \
    </dev/null 2> >(pass_on_errors) &
  child=$!
  set +m
  [ "$interrupted" = 0 ] || interrupt "$interrupted"
  wait "$child" || launched=$?
  while kill -0 "$child" 2>/dev/null; do # a signal has ended the wait
    launched=0
    wait "$child" || launched=$?
  done
  trap - INT TERM HUP

  # roslaunch tells of its own errors only, so the evolver leaves its exit status in a file.
  local status
  read -r status <"$DEVO_EVO_STATUS_FILE" || status=""
  if [ "$interrupted" != 0 ]; then
    return "$interrupted"
  elif [ "$launched" != 0 ]; then
    return "$launched"
  elif [ -z "$status" ]; then
    echo "run.sh: the evolver ended without a word; what was committed is safe, the same command goes on from there" >&2
    return 1
  elif [ "$status" != 0 ]; then
    echo "run.sh: the experiment failed; [FATAL] above says why" >&2
  fi
  return "$status"
}

read_arguments "$@"
"$repository/scripts/install_packages"
"$repository/scripts/build"

# Nodes talk to each other on this machine only, also where its host name does not resolve. ROS 1 asks nobody who he is.
export ROS_HOSTNAME=localhost
unset ROS_IP
preload=$(keep_to_loopback)
choose_port
export ROS_MASTER_URI=http://localhost:$port
if [ "$port" != 11311 ]; then
  echo "run.sh: port 11311 is in use; to look on from another terminal, export ROS_MASTER_URI=$ROS_MASTER_URI"
fi
if [ ! -w "${HOME:-/nonexistent}" ]; then
  export ROS_HOME=$BUILD_DIR/ros # where roslaunch writes its logs
fi
set +u # catkin's set-up reads variables that need not be set
# shellcheck source=/dev/null
source "$BUILD_DIR/devel/setup.bash"
set -u

DEVO_EVO_STATUS_FILE=$(mktemp)
export DEVO_EVO_STATUS_FILE
trap 'rm -f "$DEVO_EVO_STATUS_FILE"' EXIT
launch
