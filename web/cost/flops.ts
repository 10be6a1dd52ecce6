/** The powers of S (samples) and T (frames) of which a net's FLOPs are a sum. */
export const FLOPS_TERMS = ['1', 'S', 'SS', 'T', 'ST', 'TT'] as const;

export type FlopsTerm = (typeof FLOPS_TERMS)[number];

/** FLOPs (2 × multiply-accumulates) of one call: c₁ + c_S·S + c_SS·S² + c_T·T + c_ST·S·T + c_TT·T². */
export type FlopsPolynomial = Readonly<Record<FlopsTerm, number>>;

/**
 * FLOPs of one call of a net, from the polynomial in the model manifest, which `export/` counts from
 * the graph.
 *
 * @param samples S, watched frames in the window
 * @param frames T, all frames in the window
 */
export function netFlops(polynomial: FlopsPolynomial, samples: number, frames: number): number {
  return (
    polynomial['1'] +
    polynomial.S * samples +
    polynomial.SS * samples * samples +
    polynomial.T * frames +
    polynomial.ST * samples * frames +
    polynomial.TT * frames * frames
  );
}
