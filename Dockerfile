# devo_evo for systems other than Debian 12: the same scripts as ./run.sh, in an image.
#   docker build -t devo_evo .
#   docker run --rm -v "$PWD/results:/results" devo_evo output:=/results/first generations:=100
FROM debian:12
COPY . /devo_evo
RUN /devo_evo/scripts/install_packages && /devo_evo/scripts/build && rm -rf /var/lib/apt/lists/*
ENTRYPOINT ["/devo_evo/run.sh"]
