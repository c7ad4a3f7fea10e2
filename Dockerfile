# Image with the program. Build: `docker build -t touchdown .`. First flight:
# `docker run --rm -v "$PWD/out:/touchdown/out" touchdown`. Other commands of the program follow the name of the image.
FROM debian:12-slim
RUN apt-get update && apt-get install -y --no-install-recommends make && rm -rf /var/lib/apt/lists/*
WORKDIR /touchdown
COPY Makefile ./
COPY packages packages
RUN make program-deps && rm -rf /var/lib/apt/lists/*
COPY . .
RUN make build
ENTRYPOINT ["build/release/touchdown"]
CMD ["fly", "scenarios/flights/takeoff_hover_land.yaml"]
