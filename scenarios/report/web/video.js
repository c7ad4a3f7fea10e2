// The video next to the plots. Video time equals flight time.

/** Synchronizes the video with the view in both directions. `video` is null when the flight has no video. */
export function connectVideo(video, view) {
  if (!video) return;
  const updateView = () => view.play(video.currentTime);
  const updateWhilePlaying = () => {
    if (video.paused || video.ended) return;
    updateView();
    requestAnimationFrame(updateWhilePlaying);
  };
  video.addEventListener("play", updateWhilePlaying);
  video.addEventListener("pause", updateView);
  video.addEventListener("seeking", () => {
    // The video rounds the time to which the view moved it. The view keeps its own, exact time.
    if (Math.abs(video.currentTime - (view.played ?? -1)) > 1e-3) updateView();
  });
  video.addEventListener("error", () => {
    video.hidden = true;
    document.getElementById("no-video").hidden = false;
  });
  view.on("seek", () => (video.currentTime = view.played));
  view.on("toggle", () => (video.paused ? video.play() : video.pause()));
}
