// What the server says, as host/server writes it (view_site.cpp, controller_feed.cpp, tick_words.cpp, scene.cpp).

export interface Columns {
  floats: string[];
  wholes: string[];
  row_bytes: number;
}

/** Colours that carry a meaning, as #rrggbb: host/view/palette.h and colour_map.h. */
export interface Colours {
  proxy: string;
  hip: string;
  invented: string;
  rim: string;
  turned: string;
  thin: string;
  surface: string;
  distance: string[]; // inside to outside, evenly
}

export interface Hello {
  topic: 'hello';
  columns: Columns;
  colours: Colours;
  status_bits: Record<string, number>;
  scene: SceneSummary | null;
  recordings: number;
  live: boolean;
}

export interface Link {
  topic: 'link';
  there: boolean;
  sentence: string;
  period_ns?: number;
  every?: number;
}

export interface Words {
  topic: 'state';
  tick: number;
  state: string;
  sentence: string;
  fault: boolean;
  limits: string[];
}

export interface Measure {
  p50: number;
  p999: number;
  max: number;
}

export interface Status {
  topic: 'status';
  status: { [key: string]: unknown; field_hash: string | null; wakeup_us: Measure; tick_us: Measure };
  histograms_us: Record<'wakeup' | 'tick', [number, number][]>; // upper bound, count
  field_sentence?: string; // why its field cannot be drawn
}

export interface Build {
  topic: 'build';
  name: string;
  stage?: string;
  done?: number;
  result?: 'built' | 'refused' | 'failed';
  sentence?: string;
  figures?: {
    items: string;
    points: number;
    seconds?: number;
    bytes?: number;
    warnings: string[];
    verdict?: { words: string; plausible: boolean; reasons: string[] };
  };
}

export interface NewScene {
  topic: 'scene';
  scene: SceneSummary;
}

export type Message = Hello | Link | Words | Status | Build | NewScene;

export interface SceneSummary {
  name: string;
  hash: string;
  low_mm: [number, number, number];
  high_mm: [number, number, number];
  samples: [number, number, number];
  voxel_mm: number;
  band_mm: number;
  stiffness_n_per_mm: number;
  bytes: number;
  points: number;
  points_drawn: number;
  step_voxels: number;
  invented_share: number | null; // null: it has no marks, because nothing was invented, or because nobody knows, as of a controller's field
  thin_share: number;
  thin_mm: number;
  follows: boolean; // it is the field that the controller has, as it changes
}

/** Whether one field may have become the other while it grew. */
export function isOnOneGrid(a: SceneSummary, b: SceneSummary): boolean {
  const grid = (of: SceneSummary): string => [...of.low_mm, ...of.high_mm, ...of.samples].join();
  return a.follows && b.follows && grid(a) === grid(b);
}

export interface TraceEvent {
  tick: number;
  kind: 'contact' | 'fault' | 'state' | 'setting' | 'field' | 'patch' | 'stop' | 'resume';
  text: string;
}

export interface TraceSummary {
  name: string;
  ticks: number;
  period_ns: number;
  field: string; // the hash that the file names; empty: none, or any
  events: TraceEvent[];
  more_events: boolean;
  is_patched: boolean; // its field was patched meanwhile
  is_cut_off: boolean; // its file ends before it should
}

export interface Difference {
  equal: boolean;
  tick?: number;
  field?: string;
}
