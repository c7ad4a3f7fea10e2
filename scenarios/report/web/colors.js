// Colors are CSS variables of the style sheet, so that they change with the theme.

/** Current value of the CSS variable --`name`. */
export function color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Current value of the CSS variable --`name`, with an opacity from 0 to 1. */
export function tint(name, opacity) {
  const percent = Math.round(opacity * 100);
  return `color-mix(in srgb, ${color(name)} ${percent}%, transparent)`;
}

/** Name of the CSS variable with the color of a phase, without the leading hyphens. */
export function phaseColor(phase) {
  return `phase-${phase.replaceAll("_", "-")}`;
}

/** Replaces underscores by spaces: "blind_climb" becomes "blind climb". */
export function words(name) {
  return name.replaceAll("_", " ");
}
