import axe from 'axe-core';
import type { Page } from 'playwright-core';

/** What axe finds serious or critical on a page, shadow trees and frames included: one line each. */
export async function seriousFindings(page: Page): Promise<string[]> {
  const found: string[] = [];
  for (const frame of page.frames()) {
    // By the debugging protocol, which no content security policy concerns.
    await frame.evaluate(axe.source);
    const { violations } = await frame.evaluate(() =>
      window.axe.run(document, { iframes: false, resultTypes: ['violations'] }),
    );
    const serious = violations.filter(
      ({ impact }) => impact === 'serious' || impact === 'critical',
    );
    for (const { id, help, nodes } of serious) {
      found.push(
        `${id}: ${help}; ${nodes.map(({ target }) => target.flat().join(' ')).join(', ')}`,
      );
    }
  }
  return found;
}

/** What has the focus, inside shadow trees too. */
export interface Focus {
  /** Its label for people: of a button, a slider, a link. */
  readonly label: string;
  readonly tag: string;
  /** It can be seen that it has the focus. */
  readonly visible: boolean;
}

export function focused(page: Page): Promise<Focus> {
  return page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    const label = element?.getAttribute('aria-label') ?? element?.textContent?.trim() ?? '';
    // The slider is clear: what lies around it is drawn instead.
    const drawn = element?.matches('input[type=range]') ? element.parentElement : element;
    const style = drawn ? getComputedStyle(drawn) : null;
    const visible = style !== null && style.outlineStyle !== 'none' && style.outlineWidth !== '0px';
    return { label, tag: element?.localName ?? '', visible };
  });
}

/** Presses Tab until something with this label has the focus. @returns all labels on the way */
export async function tabTo(page: Page, label: string): Promise<Focus[]> {
  const passed: Focus[] = [];
  for (let press = 0; press < 60; press++) {
    await page.keyboard.press('Tab');
    const focus = await focused(page);
    passed.push(focus);
    if (focus.label === label) return passed;
  }
  throw new Error(
    `Tab never came to ${label}, but to ${passed.map((one) => one.label).join(', ')}`,
  );
}

declare global {
  interface Window {
    axe: typeof axe;
  }
}
