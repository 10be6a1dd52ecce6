/** One that draws by WebGL, and can do without while nobody sees it. */
export interface Drawer {
  readonly inSight: boolean;
  /** Gives its context back; it takes part again once it comes into sight. */
  rest(): void;
}

/**
 * Shares a page's WebGL contexts out among those that draw. A browser holds 8 (phones) to 16 of them for a
 * page and takes the oldest away beyond that, in sight or not; here those out of sight give way first.
 */
export class ContextShare {
  readonly #most: number;
  /** The one that came into sight last is last. */
  readonly #drawers = new Set<Drawer>();

  constructor(most: number) {
    this.#most = most;
  }

  /**
   * Takes part, as the one that was seen last.
   * @returns whether there is a context for it: none where it is out of sight and all others are in sight
   */
  join(drawer: Drawer): boolean {
    this.#drawers.delete(drawer);
    this.#drawers.add(drawer);
    for (const other of [...this.#drawers]) {
      if (this.#drawers.size <= this.#most) break;
      if (other.inSight) continue;
      this.#drawers.delete(other);
      other.rest();
    }
    return this.#drawers.has(drawer);
  }

  leave(drawer: Drawer): void {
    this.#drawers.delete(drawer);
  }
}
