// What all drawings have in common: which part of the flight they show, the time that is pointed at, and the time
// that is played. Whoever draws listens for "range", "pointed" and "played"; "sought" asks the video to follow.

const SHORTEST_S = 0.02;

export class TimeView {
  #listeners = { range: [], pointed: [], played: [], sought: [], toggled: [] };

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

  /** The time to tell about: what is pointed at, else what is played. */
  get current() {
    return this.pointed ?? this.played;
  }

  zoom(from, to) {
    const span = Math.min(Math.max(to - from, SHORTEST_S), this.whole.to - this.whole.from);
    const start = Math.min(Math.max(from, this.whole.from), this.whole.to - span);
    this.range = { from: start, to: start + span };
    this.#tell("range");
  }

  /** Makes the span `factor` times as long; the time `around` stays where it is. */
  scale(factor, around) {
    this.zoom(around - (around - this.range.from) * factor, around + (this.range.to - around) * factor);
  }

  reset() {
    this.zoom(this.whole.from, this.whole.to);
  }

  /** `t_s` is null when nothing is pointed at. */
  point(t_s) {
    this.pointed = t_s === null ? null : this.#within(t_s);
    this.#tell("pointed");
  }

  /** Tells that the video is at a time. */
  play(t_s) {
    this.played = this.#within(t_s);
    this.#tell("played");
  }

  /** Goes to a time, and takes the video along. */
  seek(t_s) {
    this.play(t_s);
    this.#tell("sought");
  }

  /** Starts or stops the video. */
  toggle() {
    this.#tell("toggled");
  }

  #within(t_s) {
    return Math.min(Math.max(t_s, this.whole.from), this.whole.to);
  }

  #tell(event) {
    for (const listener of this.#listeners[event]) listener(this);
  }
}
