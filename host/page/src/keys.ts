// The keys of the page, and the list of them that a person can open.
import { element, make } from './dom';

const kWhere = 'They work while the focus is on the picture or on the recording below it: click there, or go there with Tab.';

const kKeys: [string, string][] = [
  ['Arrow keys', 'turn the object (on the picture); while you touch, they move the hand, and with Shift they turn'],
  ['h, j, k, l', 'move the picture left, down, up and right'],
  ['Page up and down', 'while you touch: the hand towards you and away'],
  ['+ and −', 'nearer and further; Home: as at first'],
  ['u, p, s', 'surface, points, slice'],
  ['x, y, z and [ ]', 'axis of the slice, and one voxel along it'],
  ['Space', 'play and pause'],
  [', and .', 'one tick back and on'],
  ['c, f, g', 'next contact, fault, setting'],
  ['Mouse', 'drag turns, right button moves, wheel zooms; the slice follows the mouse'],
  ['Gamepad, to touch', 'the left stick moves the hand across the picture, the right one towards the object and away'],
  ['Mouse, to touch', 'the pointer is the hand, the wheel moves it towards the object, the right button turns'],
];

/**
 * Listens in the picture and in the player. Elsewhere a key of one character does nothing, because people who speak to their computer, or whose screen
 * reader has such keys, would press it by chance (WCAG 2.1.4).
 *
 * @param canvas the picture
 * @param onCanvas what a key does on the picture; returns false where it does nothing there
 * @param uses what the other keys do, by KeyboardEvent.key; what returns false did nothing
 */
export function bindKeys(canvas: HTMLElement, onCanvas: (event: KeyboardEvent) => boolean, uses: Record<string, () => unknown>): void {
  const help = element('help');
  const button = element('help-button');
  const show = (shown: boolean): void => {
    help.hidden = !shown;
    button.setAttribute('aria-expanded', String(shown));
  };
  button.addEventListener('click', () => show(help.hidden));
  const rows = kKeys.flatMap(([key, text]) => [make('dt', { textContent: key }), make('dd', { textContent: text })]);
  help.append(make('h2', { textContent: 'Keys' }), make('p', { textContent: kWhere }), make('dl', {}, ...rows));
  const all: Record<string, () => unknown> = { ...uses, '?': () => show(help.hidden) };
  addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (event.key === 'Escape') show(false);
    if (!target.closest('#scene, #player')) return;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches('select, input:not(#scrub)')) return;
    if (target === canvas && onCanvas(event)) {
      event.preventDefault();
      return;
    }
    if (event.key === ' ' && target.matches('button')) return; // it presses the button
    if (all[event.key]?.() !== false && event.key === ' ') event.preventDefault(); // else the page would scroll
  });
}
