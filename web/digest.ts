/** SHA-256 in lower-case hexadecimal. Browsers have it in secure contexts only. */
export async function sha256(bytes: BufferSource): Promise<string> {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** The query that a listed file is asked for with: another file has another address. */
export function versionQuery(digest: string): string {
  return `?${digest.slice(0, 16)}`;
}
