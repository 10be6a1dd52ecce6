/**
 * Interpolating B-splines of degree 2 and 3 through irregularly spaced samples, with the knots of
 * SciPy's `make_interp_spline` ("not-a-knot" for cubics), so that results equal SciPy's.
 *
 * @see de Boor, A Practical Guide to Splines (1978), chapters X and XIII
 * @see https://docs.scipy.org/doc/scipy/reference/generated/scipy.interpolate.make_interp_spline.html
 */
export class InterpolatingSpline {
  readonly #degree: number;
  readonly #channels: number;
  readonly #knots: Float64Array;
  readonly #coefficients: Float64Array;
  readonly #basis: Float64Array;

  /**
   * @param degree 2 or 3; at least degree + 1 samples are needed
   * @param times S sample times, strictly increasing
   * @param values S·C finite values
   */
  constructor(degree: 2 | 3, times: Float64Array, values: ArrayLike<number>) {
    this.#degree = degree;
    this.#channels = values.length / times.length;
    this.#knots = knotsFor(degree, times);
    this.#basis = new Float64Array(degree + 1);
    this.#coefficients = this.#solve(times, values);
  }

  /** Writes the C values at `time` into `out` from `offset` on. `time` lies within the samples. */
  evaluate(time: number, out: Float32Array | Float64Array, offset: number): void {
    const channels = this.#channels;
    const first = this.#basisAt(time);
    for (let c = 0; c < channels; c++) {
      let sum = 0;
      for (let j = 0; j <= this.#degree; j++) {
        sum += this.#basis[j]! * this.#coefficients[(first + j) * channels + c]!;
      }
      out[offset + c] = sum;
    }
  }

  /**
   * Fills `#basis` with the degree + 1 basis functions that are not zero at `time`, and returns the
   * index of the first of them (Cox–de Boor recursion).
   */
  #basisAt(time: number): number {
    const knots = this.#knots;
    const basis = this.#basis;
    const span = this.#spanOf(time);
    basis.fill(0);
    basis[0] = 1;
    for (let degree = 1; degree <= this.#degree; degree++) {
      let carried = 0;
      for (let j = 0; j < degree; j++) {
        const right = knots[span + j + 1]!;
        const left = knots[span + j + 1 - degree]!;
        const share = basis[j]! / (right - left);
        basis[j] = carried + (right - time) * share;
        carried = (time - left) * share;
      }
      basis[degree] = carried;
    }
    return span - this.#degree;
  }

  /** The last knot interval that is not empty and does not begin after `time`. */
  #spanOf(time: number): number {
    let low = this.#degree;
    let high = this.#knots.length - this.#degree - 2;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.#knots[middle]! <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /**
   * The S·C coefficients that make the spline pass through the samples. The collocation matrix has
   * `degree` diagonals on either side and is totally positive, so elimination needs no pivoting.
   */
  #solve(times: Float64Array, values: ArrayLike<number>): Float64Array {
    const samples = times.length;
    const channels = this.#channels;
    const reach = this.#degree;
    const width = 2 * reach + 1;
    const band = new Float64Array(samples * width);
    const at = (row: number, column: number) => row * width + column - row + reach;
    for (let row = 0; row < samples; row++) {
      const first = this.#basisAt(times[row]!);
      for (let j = 0; j <= reach; j++) band[at(row, first + j)] = this.#basis[j]!;
    }

    const right = Float64Array.from(values);
    const subtractRow = (row: number, from: number, factor: number) => {
      for (let c = 0; c < channels; c++) {
        right[row * channels + c]! -= factor * right[from * channels + c]!;
      }
    };
    for (let pivot = 0; pivot < samples; pivot++) {
      const end = Math.min(pivot + reach, samples - 1);
      for (let row = pivot + 1; row <= end; row++) {
        const factor = band[at(row, pivot)]! / band[at(pivot, pivot)]!;
        if (factor === 0) continue;
        for (let column = pivot; column <= end; column++) {
          band[at(row, column)]! -= factor * band[at(pivot, column)]!;
        }
        subtractRow(row, pivot, factor);
      }
    }
    for (let row = samples - 1; row >= 0; row--) {
      const end = Math.min(row + reach, samples - 1);
      for (let column = row + 1; column <= end; column++) {
        subtractRow(row, column, band[at(row, column)]!);
      }
      for (let c = 0; c < channels; c++) right[row * channels + c]! /= band[at(row, row)]!;
    }
    return right;
  }
}

/**
 * S + degree + 1 knots: the ends repeated, and between them the samples (cubic) or the midpoints
 * between samples (quadratic) without the first and the last of them.
 */
function knotsFor(degree: 2 | 3, times: Float64Array): Float64Array {
  const inner =
    degree === 3
      ? times.subarray(2, -2)
      : times.subarray(1, -2).map((time, i) => (time + times[i + 2]!) / 2);
  const repeated = (time: number) => new Array<number>(degree + 1).fill(time);
  return Float64Array.from([...repeated(times[0]!), ...inner, ...repeated(times.at(-1)!)]);
}
