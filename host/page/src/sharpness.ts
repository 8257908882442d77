// How finely the object is drawn while it moves: as finely as this computer can at a pleasant rate. At rest it is always drawn finely.

/** Of each side of the picture, the part of its pixels that is drawn; and whether its edges are smooth. */
export interface Level {
  share: number;
  smooth: boolean;
}

const kLevels: Level[] = [
  { share: 1, smooth: true },
  { share: 1, smooth: false },
  { share: 0.7, smooth: false },
  { share: 0.5, smooth: false },
  { share: 0.35, smooth: false },
];
export const kFinest: Level = { share: 1, smooth: true };

const kSlowMs = 40; // between two pictures
const kFastMs = 22;
const kMaxSlow = 2; // slow pictures one after the other
const kMinFast = 20; // fast ones before a finer level is tried, at first
const kMaxPatience = 640; // at last
const kPauseMs = 300; // what is longer is no time between two pictures of one movement

export class Sharpness {
  private number = 1; // nothing is known of this computer yet
  private last = -Infinity;
  private slow = 0;
  private fast = 0;
  private patience = kMinFast;

  /** Of the picture that is drawn at this time, ms. */
  next(now: number): Level {
    const ms = now - this.last;
    this.last = now;
    if (ms < kPauseMs) this.judge(ms);
    return kLevels[this.number] ?? kFinest;
  }

  private judge(ms: number): void {
    this.slow = ms > kSlowMs ? this.slow + 1 : 0;
    this.fast = ms < kFastMs ? this.fast + 1 : 0;
    if (this.slow >= kMaxSlow && this.number < kLevels.length - 1) {
      this.number += 1;
      this.slow = 0;
      this.patience = Math.min(2 * this.patience, kMaxPatience); // a level that was too slow is not tried again and again
    } else if (this.fast >= this.patience && this.number > 0) {
      this.number -= 1;
      this.fast = 0;
    }
  }
}
