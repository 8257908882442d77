/**
 * The Web Worker in which the core runs at 1 kHz: `new Worker(new URL("./touch_worker.js", import.meta.url), { type: "module" })`, then messages of
 * touch_messages.ts. Browsers wake a timer every 4 ms at best, so some ticks run together; each has its own place of the hand.
 */
import { TouchServer } from "./serve_touch.js";
import type { FromWorker, ToWorker } from "./touch_messages.js";

/** The part of a worker's global scope that is used; the page's own types may lack it. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transferred: Transferable[]): void;
}

const scope = globalThis as unknown as WorkerScope;
const server = new TouchServer({
  now: () => performance.now(),
  soon: (call) => void setTimeout(call, 1),
  post: (message, transferred = []) => scope.postMessage(message, transferred),
});
scope.onmessage = (event) => void server.take(event.data);
