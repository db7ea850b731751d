# devo_evo for systems other than Debian 12: the scripts of ./run.sh, in an image. (Or: podman, buildah.)
#
#   docker build -t devo_evo .
#   mkdir -p results
#   docker run --rm --user "$(id -u):$(id -g)" -v "$PWD/results:/results" devo_evo output:=/results/first generations:=100
#   docker run --rm --user "$(id -u):$(id -g)" -v "$PWD/results:/results" --entrypoint devo_evo devo_evo verify /results/first
#
# Arguments are those of run.sh, which go on with what lies in `output` already. Without `output` results go to /results, too.
FROM debian:12
COPY . /devo_evo
# git tells the commit, for the archive's provenance. Everybody may write to the build folder, where run.sh keeps its locks.
RUN apt-get update \
 && apt-get install -y --no-install-recommends git \
 && git config --system --add safe.directory /devo_evo \
 && /devo_evo/scripts/install_packages \
 && /devo_evo/scripts/build \
 && chmod -R a+rwX /devo_evo/build \
 && ln -s /devo_evo/build/devel/lib/devo_evo/devo_evo /usr/local/bin/devo_evo \
 && mkdir --mode=1777 /results \
 && rm -rf /var/lib/apt/lists/*
ENV HOME=/results ROS_HOME=/tmp/ros
WORKDIR /results
ENTRYPOINT ["/devo_evo/run.sh"]
