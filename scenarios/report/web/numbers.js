// Formats numbers.

const MAX_DECIMALS = 6;

/** Number of decimals that the multiples of `step` require. */
export function decimals(step) {
  for (let count = 0; count < MAX_DECIMALS; ++count) {
    const shifted = step * 10 ** count;
    if (Math.abs(shifted - Math.round(shifted)) < 1e-6 * shifted) return count;
  }
  return MAX_DECIMALS;
}

/** Replaces the hyphen of a negative number by a minus sign. */
export function withMinus(text) {
  return text.replace("-", "−");
}
