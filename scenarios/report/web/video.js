// The video beside the plots. Its time is the flight's time.

/** Ties it to the view both ways; `video` is null when the flight has none. */
export function connectVideo(video, view) {
  if (!video) return;
  const tell = () => view.play(video.currentTime);
  const tellWhilePlaying = () => {
    if (video.paused || video.ended) return;
    tell();
    requestAnimationFrame(tellWhilePlaying);
  };
  video.addEventListener("play", tellWhilePlaying);
  video.addEventListener("pause", tell);
  video.addEventListener("seeking", () => {
    // What the view asked for comes back rounded to the video's clock: it stays where it was asked for.
    if (Math.abs(video.currentTime - (view.played ?? -1)) > 1e-3) tell();
  });
  video.addEventListener("error", () => {
    video.hidden = true;
    document.getElementById("no-video").hidden = false;
  });
  view.on("sought", () => (video.currentTime = view.played));
  view.on("toggled", () => (video.paused ? video.play() : video.pause()));
}
