// A page that was written to a file holds everything in itself: each file that the server would send, in a script element that is no script.

/** The bytes of what the server would send from this address; null in a page that has a server. */
export function exportedBytes(name: string): Uint8Array<ArrayBuffer> | null {
  const found = document.getElementById(`data:${name}`);
  return found ? Uint8Array.from(atob((found.textContent ?? '').trim()), (character) => character.charCodeAt(0)) : null;
}

export const isExported = (): boolean => document.getElementById('data:hello') !== null;
