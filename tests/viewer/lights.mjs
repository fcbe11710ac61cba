// The lights of `zstrip render` for model files.

/** Towards the light of files that have none. */
export const kKeyDirection = [0.1, 0.8, 0.6];

/**
 * `share`: of full light. `none`: for files that have no lights, where both add up to full light; `own`: for others.
 */
export const kLights = {
  none: [{share: 104 / 255}, {share: 151 / 255, towards: kKeyDirection}],
  own: [{share: 48 / 255}, {share: 112 / 255, towards: [-0.5, 0.7, 0.6]}],
};
