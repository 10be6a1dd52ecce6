import * as v from 'valibot';
import { DeciWatchError } from '../errors.ts';
import { PoseFileSchema } from './pose-file-schema.ts';
import type { PoseFile, PoseFileFrame } from './pose-file-types.ts';

/**
 * Takes a pose file apart that may come from anywhere.
 *
 * Beyond the schema it checks what must fit together: frames complete and in order, times strictly
 * increasing, one value per joint, bones between joints that there are, and frames either with all
 * their values or with none, but that a whole file may be without 3D.
 *
 * @param json what `JSON.parse` gave
 * @throws DeciWatchError `pose-file-invalid`, with the place, what belongs there and what was found
 */
export function parsePoseFile(json: unknown): PoseFile {
  const result = v.safeParse(PoseFileSchema, json, { abortEarly: true });
  if (!result.success) throw schemaMisfit(result.issues[0]);
  const file = result.output;
  expectEqual(['source', 'frames'], file.source.frames, file.frames.length);
  expectEqual(['cost', 'frames'], file.cost.frames, file.frames.length);
  checkBones(file);
  const first = file.frames.find((frame) => frame.keypoints2d !== null);
  const isFlat = first?.keypoints3d === null;
  file.frames.forEach((frame, i) => {
    checkFrame(frame, i, file.skeleton.joints.length, isFlat);
    const before = file.frames[i - 1]?.time ?? -Infinity;
    if (frame.time > before) return;
    throw misfit(['frames', i, 'time'], `a time after the last frame's ${before} s`, frame.time);
  });
  return file;
}

type Path = readonly (string | number)[];

function schemaMisfit(issue: v.InferIssue<typeof PoseFileSchema>): DeciWatchError {
  const items = issue.path ?? [];
  const keys = items.map((item) => item.key as string | number);
  const last = items.at(-1);
  if (!last) return misfit([], issue.message, issue.input);
  // The place of an item too many is the list that holds it.
  if (issue.expected === 'never') return misfit(keys.slice(0, -1), issue.message, last.input);
  // A missing field is reported by the object around it, with that one's message.
  return misfit(keys, last.origin === 'key' ? 'a value' : issue.message, last.value);
}

function checkBones({ skeleton: { joints, bones } }: PoseFile): void {
  bones.forEach((bone, i) => {
    const [from, to] = bone;
    if (from !== to && from < joints.length && to < joints.length) return;
    const words = `a pair of different joint indices below ${joints.length}`;
    throw misfit(['skeleton', 'bones', i], words, bone);
  });
}

/** @param isFlat the file's first pose has no 3D, so that none may have */
function checkFrame(frame: PoseFileFrame, i: number, joints: number, isFlat: boolean): void {
  expectEqual(['frames', i, 'index'], frame.index, i);
  for (const field of ['keypoints2d', 'keypoints3d', 'scores'] as const) {
    const values = frame[field];
    const isEmpty = frame.keypoints2d === null || (field === 'keypoints3d' && isFlat);
    if ((values === null) !== isEmpty) {
      const others = isFlat && frame.keypoints2d ? 'as in the frames before' : 'as keypoints2d is';
      const words = `${values ? 'null' : 'a list'}, ${others}`;
      throw misfit(['frames', i, field], words, values);
    }
    if (values !== null && values.length !== joints) {
      throw misfit(['frames', i, field], `a list of ${joints} values, one per joint`, values);
    }
  }
}

function expectEqual(path: Path, found: number, expected: number): void {
  if (found !== expected) throw misfit(path, `${expected}`, found);
}

function misfit(path: Path, expected: string, found: unknown): DeciWatchError {
  const keys = path.map((key) => (typeof key === 'number' ? `[${key}]` : `.${key}`)).join('');
  const place = keys === '' ? 'The file' : `At ${keys.replace(/^\./, '')}, the file`;
  return new DeciWatchError(
    'pose-file-invalid',
    `${place} should have ${expected}, but has ${describe(found)}: it is not a sound DeciWatch ` +
      'pose file; export it again, or correct it there.',
  );
}

function describe(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === 'object' && value !== null) return 'an object';
  if (typeof value !== 'string') return String(value);
  return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
}
