import { hasPose, type PoseSequence } from '../../pose/sequence.ts';

/** Colours of the timeline, as CSS. */
export interface TimelineColours {
  readonly watched: string;
  readonly recovered: string;
  readonly gap: string;
  readonly label: string;
}

/** CSS pixels. */
export interface TimelineSize {
  readonly width: number;
  readonly height: number;
  /** Between the edge and the first or last frame's place: half the slider's thumb. */
  readonly inset: number;
  /** Of the seconds beneath; 0 leaves them out. */
  readonly labelHeight: number;
}
const TIME_STEPS_S = [0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];
const MIN_LABEL_GAP = 64;

/** A frame's place along the timeline, in CSS pixels. */
export function frameX(
  frame: number,
  frames: number,
  { width, inset }: Pick<TimelineSize, 'width' | 'inset'>,
): number {
  return inset + (frames > 1 ? (frame / (frames - 1)) * (width - 2 * inset) : 0);
}

/** The seconds between two labels, so that they have room. */
export function labelStep(duration: number, width: number): number {
  const fits = (step: number) => (step / duration) * width >= MIN_LABEL_GAP;
  return TIME_STEPS_S.find(fits) ?? TIME_STEPS_S.at(-1)!;
}

/**
 * Draws one tick for each frame: tall where the estimator looked, short where the pose was recovered, a
 * dot on the base line where nobody was seen; seconds beneath.
 *
 * @param context scaled so that one unit is one CSS pixel
 */
export function paintTimeline(
  context: CanvasRenderingContext2D,
  sequence: PoseSequence,
  size: TimelineSize,
  colours: TimelineColours,
): void {
  const frames = sequence.times.length;
  const bottom = size.height - size.labelHeight;
  const spacing = frames > 1 ? (size.width - 2 * size.inset) / (frames - 1) : size.width;
  const thin = Math.max(0.75, Math.min(2.5, spacing * 0.5));
  const thick = Math.max(1.25, Math.min(3.5, spacing * 0.75));
  for (let frame = 0; frame < frames; frame++) {
    const x = frameX(frame, frames, size);
    const watched = sequence.watched[frame] === 1;
    if (hasPose(sequence, frame)) {
      const height = watched ? bottom : bottom * 0.42;
      const width = watched ? thick : thin;
      context.fillStyle = watched ? colours.watched : colours.recovered;
      context.fillRect(x - width / 2, bottom - height, width, height);
    } else {
      context.fillStyle = colours.gap;
      const height = watched ? bottom * 0.3 : 2;
      context.fillRect(x - thin / 2, bottom - height, thin, height);
    }
  }
  if (size.labelHeight > 0) paintSeconds(context, sequence.times, size, colours.label);
}

function paintSeconds(
  context: CanvasRenderingContext2D,
  times: Float64Array,
  size: TimelineSize,
  colour: string,
): void {
  const duration = times.at(-1)! - times[0]!;
  if (duration <= 0) return;
  const inner = size.width - 2 * size.inset;
  const step = labelStep(duration, inner);
  context.fillStyle = colour;
  context.textBaseline = 'bottom';
  for (let second = 0; second <= duration; second += step) {
    const x = size.inset + (second / duration) * inner;
    const text = second < 60 ? `${second} s` : clockText(second);
    const half = context.measureText(text).width / 2;
    context.fillText(text, Math.min(Math.max(x - half, 0), size.width - 2 * half), size.height);
  }
}

function clockText(seconds: number): string {
  return `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, '0')}`;
}
