import { describe, expect, test } from 'vitest';
import { pickVideo } from '../../web/app/dropped-file.ts';
import { pageState } from '../../web/app/page-state.ts';
import type { CostReport } from '../../web/cost/report.ts';
import { compareMs, costHeadline } from '../../web/player/parts/cost-words.ts';
import {
  formatFlops,
  formatMs,
  formatOrdinal,
  formatPercent,
  formatTime,
} from '../../web/player/parts/format.ts';
import { NOT_STARTED } from '../../web/player/parts/progress-words.ts';

const plain = (text: string) => text.replaceAll('\u00a0', ' ');

const cost: CostReport = {
  frames: 100,
  estimatorCalls: 11,
  flopsPerFrame: { estimator: 1.1e8, denoise: 1e6, recover: 9e6, total: 1.2e8 },
  everyFrameFlopsPerFrame: 1e9,
  flopsRatio: 0.12,
  msPerFrame: { decode: 2, estimator: 5.5, denoise: 0.1, recover: 0.9, total: 8.5 },
  msPerEstimatorCall: 50,
  wallMs: 900,
};

describe('figures in words', () => {
  test.each([
    [formatFlops(1.632e9), '1.63 GFLOPs'],
    [formatFlops(184e6), '184 MFLOPs'],
    [formatFlops(2.5e12), '2.5 TFLOPs'],
    [formatPercent(0.1088), '10.9 %'],
    [formatPercent(1.0033), '100.3 %'],
    [formatPercent(0.05234), '5.23 %'],
    [formatMs(0.043), '0.04 ms'],
    [formatMs(7.12), '7.1 ms'],
    [formatMs(1234.4), '1,234 ms'],
    [formatTime(1.0333), '1.03 s'],
    [formatTime(125.4), '2:05.40'],
  ])('%s', (text, expected) => {
    expect(plain(text)).toBe(expected);
  });

  test('ordinals', () => {
    expect([1, 2, 3, 4, 10, 11, 12, 13, 20].map(formatOrdinal)).toEqual([
      '1st',
      '2nd',
      '3rd',
      '4th',
      '10th',
      '11th',
      '12th',
      '13th',
      '20th',
    ]);
  });

  test('the headline says how many times less, and does not boast where nothing was saved', () => {
    expect(costHeadline(cost).sentence).toContain('8.3× less');
    expect(costHeadline({ ...cost, flopsRatio: 1.003 }).sentence).not.toContain('less');
  });

  test('where the FLOPs of a look are not known, the headline says how often it looked', () => {
    const { figure, sentence } = costHeadline({ ...cost, flopsRatio: null });
    expect(plain(figure)).toBe('11 %');
    expect(sentence).toContain('not known');
  });

  test('without nets, the bars name none', () => {
    const { measured } = compareMs(cost, 'cubic');
    expect(measured.map(({ name }) => name)).toEqual(['Decoding', 'Estimator', 'Spline']);
  });

  test('the bar for every frame is decoding and one estimator call', () => {
    const { measuredTotal, everyFrameTotal } = compareMs(cost);
    expect(measuredTotal).toBeCloseTo(8.5, 9);
    expect(everyFrameTotal).toBe(52);
  });
});

describe('files that come in', () => {
  const video = { name: 'a.mp4', type: 'video/mp4' };
  const text = { name: 'b.txt', type: 'text/plain' };

  test('the first video among several is taken, and that is said', () => {
    expect(pickVideo([text, video, video])).toMatchObject({
      file: video,
      note: expect.stringContaining('a.mp4'),
    });
  });

  test('one video needs no words, and an unknown type is left to the engine', () => {
    expect(pickVideo([video]).note).toBeNull();
    expect(pickVideo([{ name: 'c.mkv', type: '' }]).file).not.toBeNull();
  });

  test('what is not a video is refused by name', () => {
    expect(pickVideo([text])).toMatchObject({ file: null, note: expect.stringContaining('b.txt') });
    expect(pickVideo([]).note).not.toBeNull();
  });
});

test('a running job comes first, and a result stays ready under a later error', () => {
  expect(pageState(NOT_STARTED, true, true)).toBe('loading');
  expect(pageState({ ...NOT_STARTED, stage: 'watching' }, false, true)).toBe('processing');
  expect(pageState(null, true, true)).toBe('ready');
  expect(pageState(null, true, false)).toBe('error');
  expect(pageState(null, false, true)).toBe('ready');
  expect(pageState(null, false, false)).toBe('idle');
});
