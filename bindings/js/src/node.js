// Modules of node, for those who run on it. Not by a name that stands here: bundlers for browsers would look for it.

/** @param name  "fs/promises" */
export const ofNode = (name) => import(/* @vite-ignore */ /* webpackIgnore: true */ `node:${name}`);
