// State that all drawings share: the visible time range, the time under the cursor and the time of the video. Drawings
// listen to "range", "pointed" and "played". The video listens to "seek" and "toggle".

const MIN_SPAN_S = 0.02;

export class TimeView {
  #listeners = { range: [], pointed: [], played: [], seek: [], toggle: [] };

  constructor(duration_s) {
    this.whole = { from: 0, to: duration_s > 0 ? duration_s : 1 };
    this.range = this.whole;
    this.pointed = null;
    this.played = null;
  }

  on(event, listener) {
    this.#listeners[event].push(listener);
  }

  get span() {
    return this.range.to - this.range.from;
  }

  /** Time of the displayed values: the time under the cursor, otherwise the time of the video. */
  get current() {
    return this.pointed ?? this.played;
  }

  zoom(from, to) {
    const span = Math.min(Math.max(to - from, MIN_SPAN_S), this.whole.to - this.whole.from);
    const start = Math.min(Math.max(from, this.whole.from), this.whole.to - span);
    this.range = { from: start, to: start + span };
    this.#notify("range");
  }

  /** Multiplies the span by `factor`. The time `around` stays in place. */
  scale(factor, around) {
    this.zoom(around - (around - this.range.from) * factor, around + (this.range.to - around) * factor);
  }

  reset() {
    this.zoom(this.whole.from, this.whole.to);
  }

  /** Sets the time under the cursor; null when there is none. */
  point(t_s) {
    this.pointed = t_s === null ? null : this.#clamp(t_s);
    this.#notify("pointed");
  }

  /** Sets the time of the video. */
  play(t_s) {
    this.played = this.#clamp(t_s);
    this.#notify("played");
  }

  /** Sets the time of the video and moves the video there. */
  seek(t_s) {
    this.play(t_s);
    this.#notify("seek");
  }

  /** Plays or pauses the video. */
  toggle() {
    this.#notify("toggle");
  }

  #clamp(t_s) {
    return Math.min(Math.max(t_s, this.whole.from), this.whole.to);
  }

  #notify(event) {
    for (const listener of this.#listeners[event]) listener(this);
  }
}
