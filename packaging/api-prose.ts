import type {
  DocBlock,
  DocCodeSpan,
  DocComment,
  DocEscapedText,
  DocFencedCode,
  DocLinkTag,
  DocNode,
  DocPlainText,
} from '@microsoft/tsdoc';
import { DocNodeKind } from '@microsoft/tsdoc';

/** A comment's parts in Markdown; each is '' where the comment has none. */
export interface Prose {
  readonly text: string;
  readonly params: ReadonlyMap<string, string>;
  readonly returns: string;
  readonly throws: string;
  readonly see: string;
}

/** @param known names that have a heading of their own, to be linked */
export function prose(comment: DocComment | undefined, known: ReadonlySet<string>): Prose {
  const write = (node: DocNode | undefined) => (node ? markdown(node, known).trim() : '');
  const blocks = (found: readonly DocBlock[]) =>
    found.map((block) => write(block.content)).join(' ');
  const throwing = comment?.customBlocks.filter((block) => block.blockTag.tagName === '@throws');
  return {
    text: [write(comment?.summarySection), write(comment?.remarksBlock?.content)]
      .filter(Boolean)
      .join('\n\n'),
    params: new Map(
      comment?.params.blocks.map((param) => [param.parameterName, write(param.content)]),
    ),
    returns: write(comment?.returnsBlock?.content),
    throws: blocks(throwing ?? []),
    see: blocks(comment?.seeBlocks ?? []),
  };
}

function markdown(node: DocNode, known: ReadonlySet<string>): string {
  switch (node.kind) {
    case DocNodeKind.PlainText:
      return (node as DocPlainText).text.replace(/[<*_]/g, '\\$&');
    case DocNodeKind.EscapedText:
      return (node as DocEscapedText).decodedText.replace(/[<*_]/g, '\\$&');
    case DocNodeKind.SoftBreak:
      return ' ';
    case DocNodeKind.CodeSpan:
      return `\`${(node as DocCodeSpan).code}\``;
    case DocNodeKind.FencedCode: {
      const { language, code } = node as DocFencedCode;
      return `\n\`\`\`${language}\n${code}\`\`\`\n\n`;
    }
    case DocNodeKind.LinkTag:
      return link(node as DocLinkTag, known);
    case DocNodeKind.Paragraph:
      return `${inside(node, known).trim()}\n\n`;
    default:
      return inside(node, known);
  }
}

function inside(node: DocNode, known: ReadonlySet<string>): string {
  return node
    .getChildNodes()
    .map((child) => markdown(child, known))
    .join('');
}

function link(
  { codeDestination, urlDestination, linkText }: DocLinkTag,
  known: ReadonlySet<string>,
) {
  if (urlDestination) return `[${linkText ?? urlDestination}](${urlDestination})`;
  const path = codeDestination?.memberReferences.map((part) => part.memberIdentifier?.identifier);
  const name = path?.[0] ?? '';
  const text = linkText ?? `\`${path?.join('.')}\``;
  return known.has(name) ? `[${text}](#${name.toLowerCase()})` : text;
}
