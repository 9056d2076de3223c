// The text of the scene: numbered lines, and marks at the lines that are refused.

const LINE = 18;

export class Editor {
  /** `typed` is called at every key, `changed` a moment after the last one. */
  constructor(root, { typed, changed }) {
    this.area = root.querySelector('textarea');
    this.gutter = root.querySelector('.gutter');
    this.list = root.querySelector('.faults');
    this.marks = new Map();
    let timer = null;
    this.setting = false;
    this.area.addEventListener('input', () => {
      if (this.setting) return;
      this.number();
      typed();
      clearTimeout(timer);
      timer = setTimeout(changed, 350);
    });
    this.area.addEventListener('scroll', () => {
      this.gutter.scrollTop = this.area.scrollTop;
    });
  }

  get text() {
    return this.area.value;
  }

  /** Puts another text there; what stood there before comes back by the browser's own undo. */
  set text(value) {
    if (value === this.area.value) return;
    const focused = document.activeElement;
    this.area.focus({ preventScroll: true });
    this.area.select();
    let taken = false;
    this.setting = true;
    try {
      taken = value !== '' && this.area.value !== '' && document.execCommand('insertText', false, value);
    } catch {
      taken = false;
    }
    if (!taken || this.area.value !== value) this.area.value = value;
    this.setting = false;
    this.area.setSelectionRange(0, 0);
    this.area.scrollTop = 0;
    if (focused !== this.area) {
      this.area.blur();
      focused?.focus?.({ preventScroll: true });
    }
    this.number();
  }

  number() {
    const count = this.area.value.split('\n').length;
    const lines = [];
    for (let line = 1; line <= count; line += 1) {
      const row = document.createElement('span');
      row.textContent = line;
      const words = this.marks.get(line);
      if (words) {
        row.className = 'refused';
        row.title = words;
      }
      lines.push(row);
    }
    this.gutter.replaceChildren(...lines);
    this.gutter.scrollTop = this.area.scrollTop;
  }

  /** Shows what is refused: places in the text, or words alone. */
  refuse(message, places) {
    this.marks = new Map(places.map(({ line, words }) => [line, words]));
    const rows = places.map(({ line, column, key, words }) => {
      const row = document.createElement('button');
      row.type = 'button';
      row.textContent = `line ${line}: ${key ? `${key}: ` : ''}${words}`;
      row.addEventListener('click', () => this.goTo(line, column));
      return row;
    });
    // The whole message shows the lines, and says what is accepted.
    if (rows.length < 2) {
      const row = document.createElement('p');
      row.textContent = message;
      rows.push(row);
    }
    this.list.replaceChildren(...rows);
    this.list.hidden = false;
    this.area.setAttribute('aria-invalid', 'true');
    this.number();
  }

  accept() {
    this.marks.clear();
    this.list.hidden = true;
    this.list.replaceChildren();
    this.area.removeAttribute('aria-invalid');
    this.number();
  }

  goTo(line, column) {
    const lines = this.area.value.split('\n');
    const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0) + Math.max(0, column - 1);
    this.area.focus();
    this.area.setSelectionRange(start, start + Math.max(1, (lines[line - 1]?.length ?? 1) - column + 1));
    this.area.scrollTop = Math.max(0, (line - 4) * LINE);
  }
}
