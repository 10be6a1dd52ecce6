/** A `_headers` file's rule: the paths that it is for, and the headers that it adds. */
interface HeaderRule {
  readonly path: RegExp;
  readonly headers: readonly (readonly [name: string, value: string])[];
}

/**
 * Reads a `_headers` file as Netlify and Cloudflare Pages do: every rule that matches adds its headers, and
 * values of the same header are joined with a comma.
 * @returns the headers of a path, names in lower case
 */
export function parseHeadersFile(text: string): (path: string) => Map<string, string> {
  const rules: HeaderRule[] = [];
  let headers: [string, string][] = [];
  for (const line of text.split('\n')) {
    if (/^\s*(#|$)/.test(line)) continue;
    if (/^\S/.test(line)) {
      headers = [];
      rules.push({ path: patternOf(line.trim()), headers });
      continue;
    }
    const colon = line.indexOf(':');
    headers.push([line.slice(0, colon).trim().toLowerCase(), line.slice(colon + 1).trim()]);
  }
  return (path) => {
    const result = new Map<string, string>();
    for (const rule of rules.filter(({ path: pattern }) => pattern.test(path))) {
      for (const [name, value] of rule.headers) {
        const before = result.get(name);
        result.set(name, before === undefined ? value : `${before}, ${value}`);
      }
    }
    return result;
  };
}

function patternOf(path: string): RegExp {
  const escaped = path.replace(/[.+?^${}()|[\]\\]/g, '\\$&').replaceAll('*', '.*');
  return new RegExp(`^${escaped}$`);
}
