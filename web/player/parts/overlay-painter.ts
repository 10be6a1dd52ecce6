import { hasPose, type PoseSequence, poseAt } from '../../pose/sequence.ts';
import { type BodySegment, bodyPlan } from '../../stage/body-plan.ts';
import { paletteFor } from '../../stage/palette.ts';
import type { Rect } from './letterbox.ts';

/** The brighter palette: a video is rarely white. */
const COLOURS = paletteFor('dark');
const CASING = 'rgba(8, 12, 18, 0.55)';
/** CSS pixels for a metre-wide limb, as a share of the picture's height: about a person of full height. */
const METRE_TO_PICTURE = 0.2;
const FAINT_SCORE = 0.15;
const SOLID_SCORE = 0.6;

/**
 * Draws one frame's 2D skeleton: dark casing first, so that it reads on any picture, then bones, then
 * joints; white joints on a watched frame.
 *
 * @param context scaled so that one unit is one CSS pixel
 * @param sequence 2D, in pixels of the source
 * @param picture where the source's pixels lie, in CSS pixels
 * @param sourceWidth pixels
 * @param presence 0 (gone) to 1 (there)
 */
export function paintOverlay(
  context: CanvasRenderingContext2D,
  sequence: PoseSequence,
  frame: number,
  picture: Rect,
  sourceWidth: number,
  presence = 1,
): void {
  if (!hasPose(sequence, frame)) return;
  const { skeleton } = sequence;
  const joints = skeleton.joints.length;
  const values = poseAt(sequence, frame);
  const scores = sequence.scores.subarray(frame * joints, (frame + 1) * joints);
  const watched = sequence.watched[frame] === 1;
  const scale = picture.width / sourceWidth;
  const plan = bodyPlan(skeleton);
  const unit = Math.max(60, picture.height * METRE_TO_PICTURE);

  const point = (of: readonly number[]) => {
    const x = of.reduce((sum, joint) => sum + values[joint * 2]!, 0) / of.length;
    const y = of.reduce((sum, joint) => sum + values[joint * 2 + 1]!, 0) / of.length;
    return [picture.x + x * scale, picture.y + y * scale] as const;
  };
  const alpha = (of: readonly number[]) => {
    const score = Math.min(...of.map((joint) => scores[joint]!));
    const solid = (score - FAINT_SCORE) / (SOLID_SCORE - FAINT_SCORE);
    return presence * (0.3 + 0.7 * Math.min(1, Math.max(0, solid)));
  };
  const stroke = (segment: BodySegment, width: number, colour: string) => {
    const [fromX, fromY] = point(segment.from);
    const [toX, toY] = point(segment.to);
    context.globalAlpha = alpha([...segment.from, ...segment.to]);
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.beginPath();
    context.moveTo(fromX, fromY);
    context.lineTo(toX, toY);
    context.stroke();
  };
  const dot = (joint: number, radius: number, colour: string) => {
    const [x, y] = point([joint]);
    context.globalAlpha = alpha([joint]);
    context.fillStyle = colour;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
  };

  context.save();
  context.lineCap = 'round';
  const lineWidth = (segment: BodySegment) => Math.max(1.2, segment.radius * 1.5 * unit);
  for (const segment of plan.segments) stroke(segment, lineWidth(segment) + 2, CASING);
  for (const segment of plan.segments) {
    stroke(segment, lineWidth(segment), COLOURS.sides[segment.side]);
  }
  plan.jointRadii.forEach((metres, joint) => {
    const radius = Math.max(1.3, metres * 0.95 * unit);
    dot(joint, radius + 1, CASING);
    dot(joint, radius, watched ? COLOURS.watched : COLOURS.sides[skeleton.sides[joint]!]);
  });
  context.restore();
}
