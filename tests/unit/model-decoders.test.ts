import { describe, expect, it } from 'vitest';
import { cropTo, toInput, toPicture } from '../../web/estimators/crop.ts';
import { decodeHeatmaps } from '../../web/estimators/heatmap.ts';
import { inputValues } from '../../web/estimators/input-values.ts';
import { decodeSimcc } from '../../web/estimators/simcc.ts';

describe('heatmaps', () => {
  /** One map from its rows. */
  const decode = (...maps: number[][][]) => {
    const shape = { keypoints: maps.length, width: maps[0]![0]!.length, height: maps[0]!.length };
    const { positions, scores } = decodeHeatmaps(Float32Array.from(maps.flat(2)), shape);
    return { positions: Array.from(positions), scores: Array.from(scores) };
  };

  it('has its keypoint at the peak, a quarter of a cell towards the higher neighbour', () => {
    const map = [
      [0, 0, 0, 0, 0],
      [0, 0, 0.5, 0, 0],
      [0, 0.25, 0.75, 0.5, 0],
      [0, 0, 0.25, 0, 0],
    ];
    expect(decode(map)).toEqual({ positions: [2.25, 1.75], scores: [0.75] });
  });

  it('is not moved between equal neighbours, nor at the border', () => {
    const even = [
      [0.25, 0.25, 0.25],
      [0.25, 0.5, 0.25],
      [0.25, 0.25, 0.25],
    ];
    const corner = [
      [0, 0, 1],
      [0, 0, 0.5],
      [0, 0, 0],
    ];
    // On the left border there is a shift in y alone.
    const edge = [
      [0, 0, 0],
      [1, 0.5, 0],
      [0.5, 0, 0],
    ];
    const { positions } = decode(even, corner, edge);
    expect(positions).toEqual([1, 1, 2, 0, 0, 1.25]);
  });

  it('takes the first of two equal peaks, and stands no map of another size', () => {
    expect(decode([[0, 1, 0, 1, 0]]).positions).toEqual([1, 0]);
    const shape = { keypoints: 2, width: 3, height: 4 };
    expect(() => decodeHeatmaps(new Float32Array(23), shape)).toThrow(RangeError);
  });

  it('is a place in a map of nothing but NaN', () => {
    const { positions } = decode([
      [NaN, NaN, NaN],
      [NaN, NaN, NaN],
    ]);
    expect(positions.every(Number.isFinite)).toBe(true);
  });
});

describe('SimCC', () => {
  it('has its keypoint at the peaks over the split ratio, as sure as the lower of the two', () => {
    const x = Float32Array.of(0, 0, 0, 0.75, 0, 0, 0.5, 0, 0, 0, 0, 0);
    const y = Float32Array.of(0, 0.5, 0, 0, 0, 0, 0, 0.25);
    const { positions, scores } = decodeSimcc(x, y, 2, 2);
    expect(Array.from(positions)).toEqual([1.5, 0.5, 0, 1.5]);
    expect(Array.from(scores)).toEqual([0.5, 0.25]);
    expect(Array.from(decodeSimcc(x, y, 2, 4).positions)).toEqual([0.75, 0.25, 0, 0.75]);
  });

  it('stands no values that cannot be spread, and no ratio of 0', () => {
    const x = new Float32Array(7);
    expect(() => decodeSimcc(x, x, 2, 2)).toThrow(RangeError);
    expect(() => decodeSimcc(new Float32Array(), x, 7, 2)).toThrow(RangeError);
    expect(() => decodeSimcc(x, x, 7, 0)).toThrow(RangeError);
  });
});

describe('a crop', () => {
  const input = { width: 192, height: 256 };

  it('holds the box, widened, about its middle, and stretches nobody', () => {
    // 100 × 320 at 1.25 is 125 × 400: the height decides, 256 / 400.
    const crop = cropTo({ x: 200, y: 40, width: 100, height: 320 }, input, 1.25);
    expect(crop.scale).toBeCloseTo(0.64, 12);
    // The middle (250, 200), less half of 192 / 0.64 = 300 and of 400.
    expect(crop.x).toBeCloseTo(100, 9);
    expect(crop.y).toBeCloseTo(0, 9);
    const corners = toInput(Float32Array.of(250, 200, 187.5, 0, 312.5, 400), crop);
    [96, 128, 56, 0, 136, 256].forEach((value, i) => {
      expect(corners[i]).toBeCloseTo(value, 4);
    });
  });

  it('of a wide box reaches beyond it above and below', () => {
    expect(cropTo({ x: 0, y: 0, width: 384, height: 100 }, input)).toEqual({
      x: 0,
      y: 50 - 256,
      scale: 0.5,
    });
  });

  it('and back is where it was', () => {
    const crop = cropTo({ x: -31.5, y: 12.25, width: 77, height: 41 }, input, 1.1);
    const points = Float32Array.of(0, 0, 640, 480, -3.5, 17.25);
    const back = toPicture(toInput(points, crop), crop);
    points.forEach((value, i) => {
      expect(back[i]).toBeCloseTo(value, 3);
    });
  });

  it('of nothing is refused', () => {
    for (const width of [0, -4, NaN, Infinity]) {
      expect(() => cropTo({ x: 0, y: 0, width, height: 10 }, input)).toThrow(RangeError);
    }
  });
});

describe("a model's input", () => {
  const rgba = Uint8ClampedArray.of(10, 20, 30, 255, 110, 120, 130, 255);
  const mean = [10, 10, 10] as const;
  const std = [1, 10, 100] as const;
  const values = (order: 'rgb' | 'bgr', layout: 'nchw' | 'nhwc') =>
    Array.from(inputValues(rgba, { mean, std, order, layout }), (v) => Math.round(v * 1e4) / 1e4);

  it('has its channels in the order and the layout asked for, mean and deviation by colour', () => {
    expect(values('rgb', 'nchw')).toEqual([0, 100, 1, 11, 0.2, 1.2]);
    expect(values('bgr', 'nchw')).toEqual([0.2, 1.2, 1, 11, 0, 100]);
    expect(values('rgb', 'nhwc')).toEqual([0, 1, 0.2, 100, 11, 1.2]);
    expect(values('bgr', 'nhwc')).toEqual([0.2, 1, 0, 1.2, 11, 100]);
  });
});
