# An image that flies: `docker build -t touchdown .`, then `docker run --rm -v "$PWD/out:/touchdown/out" touchdown`
# for the first flight, or any command of the program after the image's name.
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
