const number = (digits: number) =>
  new Intl.NumberFormat('en', { maximumSignificantDigits: digits, useGrouping: true });
const threeDigits = number(3);
const twoDigits = number(2);
const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const oneDecimal = new Intl.NumberFormat('en', { maximumFractionDigits: 1 });

const NO_BREAK = '\u00a0';

/** FLOPs with a prefix: `1.63 GFLOPs`. */
export function formatFlops(flops: number): string {
  const [scale, unit] =
    flops >= 1e12 ? [1e12, 'TFLOPs'] : flops >= 1e9 ? [1e9, 'GFLOPs'] : [1e6, 'MFLOPs'];
  return `${threeDigits.format(flops / scale)}${NO_BREAK}${unit}`;
}

/** A share as a percentage: 0.109 is `10.9 %`. */
export function formatPercent(share: number): string {
  const percent = share * 100;
  return `${percent < 10 ? threeDigits.format(percent) : oneDecimal.format(percent)}${NO_BREAK}%`;
}

/** How many times less: 9.17 is `9.2×`. */
export function formatTimes(factor: number): string {
  return `${twoDigits.format(factor)}×`;
}

/** Milliseconds: `7.1 ms`. */
export function formatMs(ms: number): string {
  const text = ms >= 100 ? whole.format(ms) : ms >= 0.095 ? ms.toFixed(1) : ms.toFixed(2);
  return `${text}${NO_BREAK}ms`;
}

/** Bytes in decimal megabytes, as download sizes are given: `9.4 MB`. */
export function formatMegabytes(bytes: number): string {
  return `${(bytes / 1e6).toFixed(1)}${NO_BREAK}MB`;
}

/** A place in a clip: `1.03 s`, or `2:05.40` from a minute on. */
export function formatTime(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(2)}${NO_BREAK}s`;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - minutes * 60).toFixed(2).padStart(5, '0')}`;
}

/** A length of time: `4.2 s`. */
export function formatSeconds(seconds: number): string {
  return `${seconds.toFixed(1)}${NO_BREAK}s`;
}

/** A whole number with thousands separated. */
export function formatCount(count: number): string {
  return whole.format(count);
}

/** `1st`, `2nd`, `3rd`, `10th`. */
export function formatOrdinal(count: number): string {
  const teen = count % 100 >= 11 && count % 100 <= 13;
  const suffix = teen ? 'th' : (['th', 'st', 'nd', 'rd'][count % 10] ?? 'th');
  return `${count}${suffix}`;
}
