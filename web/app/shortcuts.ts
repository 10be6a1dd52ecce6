/** What a key can ask for. */
export type ShortcutAction =
  | 'toggle'
  | 'back'
  | 'forward'
  | 'first'
  | 'last'
  | 'fewer'
  | 'more'
  | 'open'
  | 'save'
  | 'help';

/** The keys, as the page lists them and as it obeys them. */
export const SHORTCUTS: readonly {
  readonly keys: readonly string[];
  readonly label: string;
  readonly action: ShortcutAction;
}[] = [
  { keys: ['k', ' '], label: 'Play or pause', action: 'toggle' },
  { keys: [','], label: 'One frame back', action: 'back' },
  { keys: ['.'], label: 'One frame on', action: 'forward' },
  { keys: ['Home'], label: 'First frame', action: 'first' },
  { keys: ['End'], label: 'Last frame', action: 'last' },
  { keys: ['['], label: 'Watch more frames (N − 1)', action: 'fewer' },
  { keys: [']'], label: 'Watch fewer frames (N + 1)', action: 'more' },
  { keys: ['o'], label: 'Open a video', action: 'open' },
  { keys: ['s'], label: 'Save the poses', action: 'save' },
  { keys: ['?'], label: 'Show these keys', action: 'help' },
];

/** The part of a keyboard event that counts. */
export type KeyPress = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey'>;

/** Kinds of elements that have keys of their own. */
export type KeyTarget = 'text' | 'slider' | 'press' | 'choice' | 'other';

const OWN_KEYS: Readonly<Record<KeyTarget, (key: string) => boolean>> = {
  text: () => true,
  slider: (key) => key === 'Home' || key === 'End',
  press: (key) => key === ' ',
  choice: (key) => key === ' ' || key === 'Home' || key === 'End',
  other: () => false,
};

/** What a key press asks for, or null: a focused control keeps its own keys, and so does the browser. */
export function shortcutFor(press: KeyPress, target: KeyTarget): ShortcutAction | null {
  if (press.ctrlKey || press.metaKey || press.altKey || OWN_KEYS[target](press.key)) return null;
  const key = press.key.length === 1 ? press.key.toLowerCase() : press.key;
  return SHORTCUTS.find(({ keys }) => keys.includes(key))?.action ?? null;
}

/** The kind of an element that has the focus. */
export function keyTargetOf(element: EventTarget | undefined): KeyTarget {
  if (element instanceof HTMLInputElement) {
    if (element.type === 'range') return 'slider';
    return element.type === 'radio' || element.type === 'checkbox' ? 'choice' : 'text';
  }
  if (element instanceof HTMLTextAreaElement) return 'text';
  if (element instanceof HTMLSelectElement) return 'choice';
  return element instanceof HTMLElement && element.closest('button, summary, a')
    ? 'press'
    : 'other';
}
