import type { Frame, Page } from 'playwright-core';
import type { PlayerErrorDetail } from '../../web/player/types.ts';

/** What players on a page told, and what the page itself had to complain of. */
export interface PlayerLog {
  /** Frame numbers of the `pose` events, in order. */
  readonly poses: readonly number[];
  readonly errors: readonly Pick<PlayerErrorDetail, 'type' | 'message' | 'fatal'>[];
  readonly loads: number;
  /** Uncaught exceptions and rejections, and what a content security policy refused. */
  readonly complaints: readonly string[];
  readonly isolated: boolean;
}

declare global {
  interface Window {
    playerLog?: {
      poses: number[];
      errors: Pick<PlayerErrorDetail, 'type' | 'message' | 'fatal'>[];
      loads: number;
      complaints: string[];
    };
  }
}

/** Notes from the start what players tell, in every frame of the page; before the page is opened. */
export async function keepPlayerLog(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const log = { poses: [], errors: [], loads: 0, complaints: [] } as NonNullable<
      typeof window.playerLog
    >;
    window.playerLog = log;
    const of = (event: Event) => (event as CustomEvent).detail;
    // The events do not bubble, but come by on their way down.
    document.addEventListener('pose', (event) => log.poses.push(of(event).frame), true);
    document.addEventListener(
      'load',
      (event) => {
        if (event instanceof CustomEvent) log.loads++;
      },
      true,
    );
    document.addEventListener(
      'error',
      (event) => {
        if (!(event instanceof CustomEvent)) return;
        const { type, message, fatal } = of(event);
        log.errors.push({ type, message, fatal });
      },
      true,
    );
    document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => {
      log.complaints.push(`${violatedDirective} refused ${blockedURI}`);
    });
    addEventListener('error', ({ message }) => log.complaints.push(message));
    addEventListener('unhandledrejection', ({ reason }) => log.complaints.push(String(reason)));
  });
}

export function playerLog(frame: Page | Frame): Promise<PlayerLog> {
  return frame.evaluate(() => ({ ...window.playerLog!, isolated: crossOriginIsolated }));
}
