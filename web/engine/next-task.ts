/**
 * Lets the messages that wait (an abort, most of all) be handled before going on. A resolved promise
 * would not do: its continuation runs before any message. A timer would wait 4 ms each time.
 */
export function nextTask(): Promise<void> {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve) => {
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
