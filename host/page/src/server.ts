// The server of this page: what it is asked for, and what it says by itself. A page from a file has none and finds everything in itself.
import { exportedBytes, isExported } from './exported';
import type { Difference, Message, SceneSummary, TraceSummary, Words } from './messages';

/** The server's own sentence. */
export class Refused extends Error {
  constructor(
    sentence: string,
    readonly status: number,
  ) {
    super(sentence);
  }
}

export interface Listener {
  message(message: Message): void;
  /** Rows of ticks: first tick, ticks from row to row, and the rows. */
  ticks(first: number, every: number, rows: DataView): void;
  /** Empty: connected. */
  connection(sentence: string): void;
}

/** How long after a lost connection it is tried again. */
const kAgainMs = 1000;

/** Bytes before the rows of a batch: controller_feed.cpp. */
const kBatchHeader = 16;

export class Server {
  private async get(path: string): Promise<Response> {
    const own = isExported() ? exportedBytes(path.split('?')[0] ?? '') : null;
    if (own) return new Response(own);
    const answer = await fetch(path, { cache: 'no-store' });
    if (!answer.ok) throw new Refused((await answer.text()).trim(), answer.status);
    return answer;
  }

  private async json<T>(path: string): Promise<T> {
    return (await (await this.get(path)).json()) as T;
  }

  private async bytes(path: string): Promise<DataView> {
    return new DataView(await (await this.get(path)).arrayBuffer());
  }

  /** A part of this object: 'surface', 'points', 'rim', 'turned' or 'field'. Refused when there is another object by now. */
  part(name: string, of: SceneSummary): Promise<DataView> {
    return this.bytes(`${name}?of=${of.hash}`);
  }
  trace(number: number): Promise<TraceSummary> {
    return this.json(`trace/${number}`);
  }
  rows(number: number, from: number, count: number): Promise<DataView> {
    return this.bytes(`trace/${number}/rows?from=${from}&count=${count}`);
  }
  curves(number: number, from: number, to: number, pieces: number): Promise<DataView> {
    return this.bytes(`trace/${number}/curves?from=${from}&to=${to}&pieces=${pieces}`);
  }
  words(number: number, tick: number): Promise<Words> {
    return this.json(`trace/${number}/words?tick=${tick}`);
  }
  difference(): Promise<Difference | null> {
    return this.json('difference');
  }
  slice(of: SceneSummary, axis: string, at: number, samples: number): Promise<DataView> {
    return this.bytes(`slice?of=${of.hash}&axis=${axis}&at=${at}&samples=${samples}`);
  }

  async build(name: string, file: Blob): Promise<void> {
    const answer = await fetch(`build?name=${encodeURIComponent(name)}`, { method: 'POST', body: file });
    if (!answer.ok) throw new Refused((await answer.text()).trim(), answer.status);
  }

  /** Listens for as long as the page lives. */
  listen(listener: Listener): void {
    if (isExported()) {
      void this.json<Message>('hello').then((hello) => listener.message(hello));
      return;
    }
    const socket = new WebSocket(new URL('socket', location.href.replace(/^http/, 'ws')));
    socket.binaryType = 'arraybuffer';
    socket.onopen = (): void => listener.connection('');
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>): void => {
      if (typeof event.data === 'string') {
        listener.message(JSON.parse(event.data) as Message);
        return;
      }
      const view = new DataView(event.data);
      const first = Number(view.getBigUint64(0, true));
      listener.ticks(first, view.getUint32(8, true), new DataView(event.data, kBatchHeader));
      // The next batch is sent when this one was drawn: a page that is slow gets the newest ticks, not the oldest.
      requestAnimationFrame(() => {
        if (socket.readyState === WebSocket.OPEN) socket.send('seen');
      });
    };
    socket.onclose = (event: CloseEvent): void => {
      listener.connection(event.reason || 'The server does not answer; see whether isotouch view still runs. This page tries again by itself.');
      setTimeout(() => this.listen(listener), kAgainMs);
    };
  }
}
