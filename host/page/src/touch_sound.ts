// A quiet sound that follows force and slip, for whoever turns it on.
import { length, type Tick } from './rows';

const kMaxGain = 0.15;

export class TouchSound {
  private context: AudioContext | null = null;
  private gain: GainNode | null = null;
  private filter: BiquadFilterNode | null = null;

  /** Browsers begin to sound only when a person has pressed something. */
  turn(on: boolean): void {
    if (!on) {
      void this.context?.close();
      this.context = this.gain = this.filter = null;
      return;
    }
    const context = new AudioContext();
    const noise = context.createBuffer(1, context.sampleRate, context.sampleRate);
    const samples = noise.getChannelData(0);
    for (let i = 0; i < samples.length; ++i) samples[i] = 2 * Math.random() - 1;
    const source = new AudioBufferSourceNode(context, { buffer: noise, loop: true });
    this.filter = new BiquadFilterNode(context, { type: 'bandpass', Q: 2, frequency: 200 });
    this.gain = new GainNode(context, { gain: 0 });
    source.connect(this.filter).connect(this.gain).connect(context.destination);
    source.start();
    this.context = context;
  }

  /** The hand has left. */
  rest(): void {
    if (this.context) this.gain?.gain.setTargetAtTime(0, this.context.currentTime, 0.02);
  }

  /** Louder with the force, higher with the speed of the proxy. */
  follow(before: Tick | null, now: Tick, seconds: number): void {
    if (!this.context || !this.gain || !this.filter || !before || seconds <= 0) return;
    const slip = Math.hypot(now.proxy.x - before.proxy.x, now.proxy.y - before.proxy.y, now.proxy.z - before.proxy.z) / seconds; // mm/s
    const loud = now.contact ? kMaxGain * Math.min(1, length(now.force) / 3) * Math.min(1, slip / 40) : 0;
    this.gain.gain.setTargetAtTime(loud, this.context.currentTime, 0.02);
    this.filter.frequency.setTargetAtTime(150 + 8 * Math.min(slip, 300), this.context.currentTime, 0.02);
  }
}
