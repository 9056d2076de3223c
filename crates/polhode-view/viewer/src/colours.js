// Colours of bodies, islands, overlays and plots. They are meant for both themes; greys come from the theme.

/** Bodies that move, by index, where the page does not say their colours: those of pictures (polhode, appearance.rs). */
export const BODY_COLOURS = ['#5692cc', '#e69f3c', '#3ca57d', '#d6693c', '#cc82ac', '#e2d050', '#8080c8'];

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

/** Events by their kind: what strikes red, what begins blue, what ends grey, what slides orange, what rests green. */
const EVENT_COLOURS = {
  impact: '#d8334a',
  contact_begin: '#3b7dd8',
  contact_end: '#7c8b99',
  rest: '#3f9d6c',
  wake: '#b8962e',
  detach: '#2aa5b5',
  stick: '#5f7a2f',
  slide: '#e07f00',
  jam: '#8a6bd1',
  break: '#c45fb5',
};
/** Any other kind. */
const OTHER_EVENT = '#9a6240';

/** The colour of a kind of event, the same in every page. */
export const eventColour = (kind) => EVENT_COLOURS[kind] ?? OTHER_EVENT;
