// The elements of index.html, and new ones.

/** The element with this id; index.html has it. */
export function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`index.html has no element '${id}'`);
  return found as T;
}

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Partial<HTMLElementTagNameMap[K]> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Changes a text only where it is another one: a screen reader reads what changes. */
export function say(where: HTMLElement, text: string): void {
  if (where.textContent !== text) where.textContent = text;
  where.hidden = text === '';
}

/** A button that stays pressed. */
export function toggle(label: string, key: string, pressed: boolean, use: (pressed: boolean) => void): HTMLButtonElement {
  const button = make('button', { type: 'button', textContent: label });
  const show = (on: boolean): void => button.setAttribute('aria-pressed', String(on));
  if (key !== '') {
    button.title = `key ${key}`;
    button.setAttribute('aria-keyshortcuts', key);
  }
  button.addEventListener('click', () => {
    const on = button.getAttribute('aria-pressed') !== 'true';
    show(on);
    use(on);
  });
  show(pressed);
  return button;
}

/** Buttons of which one is pressed. */
export class Choice {
  private readonly buttons = new Map<string, HTMLButtonElement>();
  constructor(
    private readonly where: HTMLElement,
    private readonly use: (name: string) => void,
  ) {}

  add(name: string, label: string): void {
    if (this.buttons.has(name)) return;
    const button = make('button', { type: 'button', textContent: label });
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('click', () => this.choose(name));
    this.buttons.set(name, button);
    this.where.append(button);
  }

  choose(name: string): void {
    if (!this.buttons.has(name)) return;
    for (const [other, button] of this.buttons) button.setAttribute('aria-pressed', String(other === name));
    this.use(name);
  }
}
