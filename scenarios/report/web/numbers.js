// Writing numbers.

const MOST_DECIMALS = 6;

/** How many decimals the multiples of `step` need. */
export function decimals(step) {
  for (let count = 0; count < MOST_DECIMALS; ++count) {
    const shifted = step * 10 ** count;
    if (Math.abs(shifted - Math.round(shifted)) < 1e-6 * shifted) return count;
  }
  return MOST_DECIMALS;
}

/** With a minus sign for the hyphen. */
export function withMinus(text) {
  return text.replace("-", "−");
}
