// Colours of bodies, islands, overlays and plots. They are meant for both themes; greys come from the theme.

/** Bodies that move, by index. Muted, so that overlays stand out. */
export const BODY_COLOURS = ['#6f93b8', '#cf9a69', '#83a978', '#bf8296', '#938abd', '#b3a463'];

/** Islands, by the lowest index of their bodies. */
export const ISLAND_COLOURS = [
  '#3b82c4',
  '#e0803a',
  '#4ba35a',
  '#c75b7a',
  '#7d6cc7',
  '#c2a02c',
  '#2fa3a0',
  '#a8623b',
  '#8c9b30',
  '#c45fb5',
];

/** Series of a plot, by index. */
export const SERIES_COLOURS = [
  '#3b7dd8',
  '#e07b39',
  '#3f9d6c',
  '#c94f6d',
  '#8a6bd1',
  '#b8962e',
  '#2aa5b5',
  '#9a6240',
  '#7c8b99',
  '#d460b0',
];

export const FORCE_COLOUR = '#d8334a';
export const JOINT_COLOUR = '#a020a8';
export const NORMAL_COLOUR = '#13988a';
export const MANIFOLD_COLOUR = '#eba715';
export const VELOCITY_COLOUR = '#2677dd';
export const SPIN_COLOUR = '#e07f00';
export const MOMENTUM_COLOUR = '#8b46c9';
export const HALO_COLOUR = '#d8334a';
export const SELECTED_COLOUR = '#ff5a1f';

/** Kinds of events, by their order in the list of kinds. */
export const EVENT_COLOURS = ['#d8334a', '#3b7dd8', '#e07f00', '#3f9d6c', '#8a6bd1', '#b8962e', '#2aa5b5', '#c45fb5'];
