// Looking things up in rising times.

/** The index of the time nearest to `t`; -1 when there is none. */
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

/** The value of the row nearest to `t`; null where there is none, and further from a row than `reach_s`. */
export function valueAt(times, values, t, reach_s) {
  const index = nearestIndex(times, t);
  return index < 0 || Math.abs(times[index] - t) > reach_s ? null : values[index];
}

/** The span of `spans` that `t` lies in, or undefined. */
export function spanAt(spans, t) {
  return spans.find((span) => span.from_s <= t && t <= span.to_s);
}
