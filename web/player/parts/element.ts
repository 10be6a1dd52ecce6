/**
 * Registers a custom element, as Lit's `customElement` does, unless the page has one of that name: a page
 * may load this code twice, from two hosts or in two versions. The first one is used by all.
 */
export function element(name: string) {
  return (definition: CustomElementConstructor): void => {
    if (!customElements.get(name)) customElements.define(name, definition);
  };
}
