// Colors are custom properties of the style sheet, so that they change with the theme.

/** What the style sheet says of --`name` now. */
export function color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** The same with an opacity. */
export function tint(name, opacity) {
  const percent = Math.round(opacity * 100);
  return `color-mix(in srgb, ${color(name)} ${percent}%, transparent)`;
}

/** The name of a phase's color. */
export function phaseColor(phase) {
  return `phase-${phase.replaceAll("_", "-")}`;
}

/** "blind_climb" as "blind climb". */
export function words(name) {
  return name.replaceAll("_", " ");
}
