# TDBD in a container. Not tested: no container runtime was available. The Debian package that it installs is tested in a
# fresh Debian 12 (bash scripts/package --smoke).
#   docker build -t tdbd .
#   docker run --rm -v "$PWD:/data" tdbd run /usr/share/tdbd/cases/bit-b-steady.toml -o first
FROM debian:12 AS build
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates git
COPY . /source
WORKDIR /source
RUN bash scripts/setup package && bash scripts/package deb

FROM debian:12-slim
COPY --from=build /source/build/packages/tdbd_*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/tdbd_*.deb && rm -rf /tmp/tdbd_*.deb /var/lib/apt/lists/*
WORKDIR /data
ENTRYPOINT ["tdbd"]
CMD ["--help"]
