// Islands in colours, resting bodies in grey.
//
// Island numbers are those of one frame; the colour follows the lowest body of an island, so that it stays while the
// island does.

import { Group } from 'three';
import { ISLAND_COLOURS } from '../colours.js';
import { AT_REST } from '../snapshot.js';
import { colour } from '../theme.js';

export class Islands {
  constructor(view) {
    this.view = view;
    this.group = new Group();
  }

  update() {
    const { run, snapshot, bodies } = this.view;
    const lowest = new Map();
    for (const body of run.moving) {
      const island = snapshot.islandOf(body);
      if (island !== null && !lowest.has(island)) lowest.set(island, body);
    }
    const resting = colour('resting');
    const alone = colour('alone');
    bodies.paint((body) => {
      if (snapshot.kindOf(body) === null) return bodies.plainColour(body);
      if (snapshot.kindOf(body) === AT_REST) return resting;
      const island = snapshot.islandOf(body);
      return island === null ? alone : ISLAND_COLOURS[lowest.get(island) % ISLAND_COLOURS.length];
    });
  }

  hidden() {
    this.view.bodies.paint((body) => this.view.bodies.plainColour(body));
  }

  legend() {
    return [
      { colour: colour('resting'), text: 'at rest' },
      { colour: colour('alone'), text: 'in no island' },
      { colour: ISLAND_COLOURS[0], text: 'one colour for each island' },
    ];
  }
}
