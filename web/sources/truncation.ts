import { EncodedPacketSink, type InputVideoTrack } from 'mediabunny';
import { DeciWatchError } from '../errors.ts';

/**
 * The error to tell of a file that lists frames whose data lies beyond its end (a download or a
 * copy that was cut off), or null where the last frame's data is there.
 * @param times T seconds, of every frame that the file lists
 */
export async function truncation(
  track: InputVideoTrack,
  times: Float64Array,
  name: string,
): Promise<DeciWatchError | null> {
  const sink = new EncodedPacketSink(track);
  const isThere = async (frame: number) => (await sink.getPacket(times[frame]!)) !== null;
  if (await isThere(times.length - 1)) return null;
  // Data is stored in the order of time, but for the few frames that B-frames swap.
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (await isThere(middle)) low = middle + 1;
    else high = middle;
  }
  const second = (times[low]! - times[0]!).toFixed(1);
  return new DeciWatchError(
    'file-truncated',
    `${name} is cut off: its pictures stop at second ${second}, although it lists ${times.length} frames; ` +
      'copy or download it again.',
  );
}
