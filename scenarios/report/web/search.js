// Look-ups in ascending times.

/** Index of the time nearest to `t`; -1 when `times` is empty. */
export function nearestIndex(times, t) {
  if (times.length === 0) return -1;
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return t - times[low] <= times[high] - t ? low : high;
}

/** Value at the time nearest to `t`; null when it has no value or is more than `max_distance_s` away from `t`. */
export function valueAt(times, values, t, max_distance_s) {
  const index = nearestIndex(times, t);
  return index < 0 || Math.abs(times[index] - t) > max_distance_s ? null : values[index];
}

/** First span that contains `t`; undefined when there is none. */
export function spanAt(spans, t) {
  return spans.find((span) => span.from_s <= t && t <= span.to_s);
}
