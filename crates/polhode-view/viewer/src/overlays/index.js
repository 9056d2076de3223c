// All overlays, in the order of their keys 1 to 9.
//
// An overlay is built for the view of one run and has `group` (what is drawn), update() (called while it is on),
// legend() (lines for the key of colours) and, where it changes the bodies themselves, hidden() (called when it goes
// off).

import { Boxes } from './boxes.js';
import { Contacts } from './contacts.js';
import { Edges } from './edges.js';
import { Islands } from './islands.js';
import { Manifolds } from './manifolds.js';
import { Polhode } from './polhode.js';
import { Spins } from './spins.js';
import { Traces } from './traces.js';
import { Velocities } from './velocities.js';

/** `of_contacts`: needs runs whose frames hold contacts. */
export const OVERLAYS = [
  { name: 'contacts', label: 'Contacts, joints', of_contacts: true, kind: Contacts },
  { name: 'manifolds', label: 'Manifolds', of_contacts: true, kind: Manifolds },
  { name: 'velocities', label: 'Velocities', of_contacts: false, kind: Velocities },
  { name: 'spins', label: 'Spin, momentum', of_contacts: false, kind: Spins },
  { name: 'polhode', label: 'Polhode', of_contacts: false, kind: Polhode },
  { name: 'traces', label: 'Traces', of_contacts: false, kind: Traces },
  { name: 'boxes', label: 'Boxes', of_contacts: false, kind: Boxes },
  { name: 'islands', label: 'Islands, rest', of_contacts: true, kind: Islands },
  { name: 'edges', label: 'Edges', of_contacts: false, kind: Edges },
];
