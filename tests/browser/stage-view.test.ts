import { afterEach, expect, test } from 'vitest';
import { StageView } from '../../web/player/parts/stage-view.ts';

const MANY = 10;
const MOST = 6;

afterEach(() => document.body.replaceChildren());

function stack(count: number): StageView[] {
  const views = Array.from({ length: count }, () => new StageView());
  for (const view of views) view.style.height = '400px';
  document.body.append(...views);
  return views;
}

const canvasOf = (view: StageView) =>
  view.shadowRoot?.querySelector<HTMLCanvasElement>('.canvas canvas');

const drawing = (views: readonly StageView[]) => views.filter((view) => canvasOf(view));

const press = (view: StageView, label: string) =>
  [...view.shadowRoot!.querySelectorAll('button')]
    .find((button) => button.textContent === label)!
    .click();

// biome-ignore lint/complexity/useLiteralKeys: private
const cameraOf = (view: StageView) => view['stage']!.camera;

test('many on a page share its WebGL contexts: those out of sight rest, and come back as they were', async () => {
  const views = stack(MANY);
  const [first, last] = [views[0]!, views.at(-1)!];
  await expect.poll(() => drawing(views).length).toBe(MOST);
  expect(canvasOf(first)).toBeTruthy();
  const context = canvasOf(first)!.getContext('webgl2')!;
  press(first, 'Side');
  const { from } = cameraOf(first).place;

  last.scrollIntoView();
  await expect.poll(() => canvasOf(last)).toBeTruthy();
  // Scrolled through one by one, each has its turn.
  for (const view of views.toReversed().slice(0, -1)) {
    view.scrollIntoView();
    await expect.poll(() => canvasOf(view)).toBeTruthy();
    expect(drawing(views).length).toBeLessThanOrEqual(MOST);
  }
  await expect.poll(() => context.isContextLost()).toBe(true);

  first.scrollIntoView();
  await expect.poll(() => canvasOf(first)).toBeTruthy();
  const back = cameraOf(first).place;
  expect([back.from.radius, back.from.phi, back.from.theta]).toEqual(
    [from.radius, from.phi, from.theta].map((value) => expect.closeTo(value, 5)),
  );
});

test('one that is moved on the page keeps its viewpoint', async () => {
  const [view] = stack(1) as [StageView];
  await expect.poll(() => canvasOf(view)).toBeTruthy();
  press(view, 'Top');
  const { from } = cameraOf(view).place;
  document.body.append(document.createElement('p'), view);
  await expect.poll(() => canvasOf(view)).toBeTruthy();
  expect(cameraOf(view).place.from.phi).toBeCloseTo(from.phi, 5);
});
