// What stands beside the picture in words: the figures of the object, and what the signs mean.
import { element, make } from './dom';
import type { Colours, SceneSummary } from './messages';
import { kArrowMmPerN } from './touch_marks';

export function showFacts(summary: SceneSummary): void {
  const size = summary.high_mm.map((high, axis) => (high - (summary.low_mm[axis] ?? 0)).toFixed(0)).join(' × ');
  const facts: [string, string][] = [
    ['Grid', `${summary.samples.join(' × ')} samples`],
    ['Its size', `${size} mm`],
    ['Voxel', `${summary.voxel_mm.toFixed(3)} mm`],
    ['Stiffness', `${summary.stiffness_n_per_mm.toFixed(2)} N/mm`],
    ['Memory', `${(summary.bytes / 1024).toFixed(0)} KiB`],
    ...(summary.invented_share === null ? [] : [['Surface invented', `${(100 * summary.invented_share).toFixed(1)} %`] as [string, string]]),
    [`Walls thinner than ${summary.thin_mm.toFixed(1)} mm`, `${(100 * summary.thin_share).toFixed(1)} % of the surface`],
    ['Drawn with a step of', `${summary.step_voxels} ${summary.step_voxels === 1 ? 'voxel' : 'voxels'}`],
    ...(summary.points > 0 ? [['Points', summary.points_drawn < summary.points ? `${summary.points}, ${summary.points_drawn} drawn` : `${summary.points}`] as [string, string]] : []),
    ['Hash', summary.hash],
  ];
  const table = element<HTMLTableElement>('facts');
  table.tBodies[0]?.replaceChildren(...facts.map(([label, text]) => make('tr', {}, make('th', { scope: 'row', textContent: label }), make('td', { textContent: text }))));
  table.hidden = false;
}

/** What the signs mean that are in the picture; those of a doubtful object are named only where it has them. */
export function showLegend(colours: Colours, has: { invented: boolean; thin: boolean; rim: boolean; turned: boolean }): void {
  const sign = (shape: string, colour: string, text: string): HTMLLIElement => {
    const key = make('span', { className: `sign ${shape}` });
    key.style.setProperty('--colour', colour);
    key.setAttribute('aria-hidden', 'true');
    return make('li', {}, key, text);
  };
  element('legend').replaceChildren(
    sign('cube', colours.hip, 'hand (HIP)'),
    sign('ball', colours.proxy, 'proxy'),
    sign('arrow', 'currentColor', `force, ${kArrowMmPerN} mm a newton`),
    ...(has.invented ? [sign('hatch', colours.invented, 'invented: nobody scanned this')] : []),
    ...(has.thin ? [sign('hatch thin', colours.thin, 'thin wall')] : []),
    ...(has.rim ? [sign('line', colours.rim, 'rim of an open scan')] : []),
    ...(has.turned ? [sign('bristle', colours.turned, 'normal that was turned')] : []),
  );
}
