import type { RecoverProgress } from '../engine/types.ts';

const STAGE_WORDS = {
  loading: 'loading models',
  watching: 'watching',
  recovering: 'recovering',
} as const;

/** One line that is rewritten in a terminal, and one line per clip and quarter in a log. */
export class ProgressLine {
  #lastQuarter = -1;

  constructor(
    private readonly name: string,
    private readonly stream: NodeJS.WriteStream = process.stderr,
  ) {}

  update(progress: RecoverProgress): void {
    const percent = Math.floor(progress.fraction * 100);
    const frames = progress.framesTotal
      ? `, ${progress.framesDone} of ${progress.framesTotal} frames`
      : '';
    const text = `${this.name}: ${percent} % (${STAGE_WORDS[progress.stage]}${frames})`;
    if (this.stream.isTTY) {
      this.stream.write(`\r\x1b[2K${text}`);
      return;
    }
    const quarter = Math.floor(percent / 25);
    if (quarter > this.#lastQuarter) {
      this.#lastQuarter = quarter;
      this.stream.write(`${text}\n`);
    }
  }

  /** Clears the line in a terminal, so that what is printed next stands alone. */
  end(): void {
    if (this.stream.isTTY) this.stream.write('\r\x1b[2K');
  }
}
