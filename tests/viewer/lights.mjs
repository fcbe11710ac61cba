// The lights of `zstrip render` for model files.

const kAmbient = {
  share: 48 / 255
};

/** Towards the light that it adds. */
export const kKeyDirection = [-0.5, 0.7, 0.6];

/**
 * `share`: of full light. `none`: for files that have no lights, where both add up to full light; `own`: for others.
 */
export const kLights = {
  none: [kAmbient, {share: 207 / 255, towards: kKeyDirection}],
  own: [kAmbient, {share: 112 / 255, towards: kKeyDirection}],
};
