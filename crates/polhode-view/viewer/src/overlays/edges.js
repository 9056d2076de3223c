// Sharp edges of the bodies as lines.

import { Group } from 'three';

export class Edges {
  constructor(view) {
    this.view = view;
    this.group = new Group();
  }

  update() {
    this.view.bodies.showEdges(true);
  }

  hidden() {
    this.view.bodies.showEdges(false);
  }

  legend() {
    return [];
  }
}
