import {
  type ApiDeclaredItem,
  ApiDocumentedItem,
  type ApiEntryPoint,
  type ApiItem,
  ApiItemContainerMixin,
  ApiItemKind,
  ApiParameterListMixin,
} from '@microsoft/api-extractor-model';
import type { PublicApi } from './api-model.ts';
import { type Prose, prose } from './api-prose.ts';
import type { Topic } from './api-topics.ts';

/** One chapter of the reference for each group of topics. */
export interface Chapter {
  readonly heading: string;
  readonly words: string;
  readonly entry: ApiEntryPoint;
  readonly topics: readonly Topic[];
}

/**
 * The reference in one Markdown file.
 * @throws Error where an export has no topic or no comment, or a topic names what is not exported
 */
export function apiMarkdown(head: string, chapters: readonly Chapter[], { text }: PublicApi) {
  const names = chapters.flatMap(({ topics }) => topics.flatMap((topic) => topic.names));
  const known = new Set(names);
  const parts = chapters.map(({ heading, words, entry, topics }) =>
    [
      `## ${heading}\n\n${words}\n`,
      ...topics.map((topic) =>
        [
          `### ${topic.heading}\n`,
          ...byKind(entry, topic.names).map((item) => exported(item, known, text)),
        ].join('\n'),
      ),
    ].join('\n'),
  );
  return [head, contents(chapters), ...parts].join('\n');
}

function contents(chapters: readonly Chapter[]): string {
  const lines = chapters.flatMap(({ entry, topics }) =>
    topics.map(({ heading, names }) => {
      const links = byKind(entry, names).map(({ displayName }) => displayName);
      const list = links.map((name) => `[\`${name}\`](#${name.toLowerCase()})`);
      return `- **${heading}**: ${list.join(', ')}`;
    }),
  );
  return `${lines.join('\n')}\n`;
}

/** What is called first, what it takes and gives after it. */
const KINDS = [ApiItemKind.Function, ApiItemKind.Class, ApiItemKind.Variable];

function byKind(entry: ApiEntryPoint, names: readonly string[]): ApiItem[] {
  const items = names.map((name) => {
    const item = entry.findMembersByName(name)[0];
    if (!item) throw new Error(`${name} has a topic, but is not exported.`);
    return item;
  });
  const others = items.filter(({ kind }) => !KINDS.includes(kind));
  return [...KINDS.flatMap((kind) => items.filter((item) => item.kind === kind)), ...others];
}

function exported(item: ApiItem, known: ReadonlySet<string>, text: string): string {
  const name = item.displayName;
  const words = proseOf(item, known);
  if (!words.text) throw new Error(`${name} is exported, but nothing is said of it.`);
  const parts = [`#### ${name}\n`, `\`\`\`ts\n${signature(item)}\n\`\`\`\n`, `${words.text}\n`];
  const details = detailsOf(item, words);
  if (details) parts.push(`${details}\n`);
  const members = membersOf(item, text).map((member) => memberLine(member, known));
  if (members.length > 0) parts.push(`${members.join('\n')}\n`);
  return parts.join('\n');
}

function proseOf(item: ApiItem, known: ReadonlySet<string>): Prose {
  const words = prose(item instanceof ApiDocumentedItem ? item.tsdocComment : undefined, known);
  // What api-extractor says of every constructor that has no comment.
  const isEmpty = words.text.startsWith('Constructs a new instance');
  return isEmpty ? { ...words, text: '' } : words;
}

/** Parameters, result and errors, a line each. */
function detailsOf(item: ApiItem, { params, returns, throws, see }: Prose): string {
  const lines: string[] = [];
  if (ApiParameterListMixin.isBaseClassOf(item)) {
    for (const { name } of item.parameters) {
      const words = params.get(name);
      if (words) lines.push(`- \`${name}\`: ${words}`);
    }
  }
  if (returns) lines.push(`- Returns ${returns}`);
  if (throws) lines.push(`- Throws ${throws}`);
  if (see) lines.push(`- See ${see}`);
  return lines.join('\n');
}

function memberLine(member: ApiItem, known: ReadonlySet<string>): string {
  const words = proseOf(member, known);
  const details = detailsOf(member, words).replace(/^/gm, '  ').trimEnd();
  const line = `- \`${signature(member).replace(/\s+/g, ' ')}\``;
  return [words.text ? `${line}: ${words.text}` : line, details].filter(Boolean).join('\n');
}

/** Without what is the same for all of them. */
function signature(item: ApiItem): string {
  const kind = item.kind === ApiItemKind.Variable ? 'const ' : '';
  return kind + declared(item);
}

function declared(item: ApiItem): string {
  return (item as ApiDeclaredItem).excerpt.text
    .replace(/^export /, '')
    .replace(/^declare /, '')
    .replace(/;?\s*$/, '');
}

/** Of overloads, only the first. */
function membersOf(item: ApiItem, text: string): ApiItem[] {
  if (!ApiItemContainerMixin.isBaseClassOf(item)) return [];
  const start = text.search(new RegExp(`\\b(interface|class) ${item.displayName}\\b`));
  const first = item.members.filter(
    (member) => !ApiParameterListMixin.isBaseClassOf(member) || member.overloadIndex <= 1,
  );
  return inOrder(first, text, start);
}

/** In the order in which they are written from a place in the declarations' text on. */
export function inOrder(items: readonly ApiItem[], text: string, start = 0): ApiItem[] {
  const place = (item: ApiItem) => {
    const [line] = declared(item).split('\n', 1);
    return text.indexOf(line!, start);
  };
  return [...items].sort((a, b) => place(a) - place(b));
}
