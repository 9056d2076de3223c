// Light and dark: the colours stand in viewer.css as light-dark() pairs and are read from there, so that page and
// picture always agree.

let probe = null;

/** The colour of a CSS variable of the page as it is now, "rgb(r, g, b)". */
export function colour(name) {
  if (!probe) {
    probe = document.createElement('span');
    probe.hidden = true;
    document.body.append(probe);
  }
  probe.style.color = `var(--${name})`;
  return getComputedStyle(probe).color;
}

/** Whether the page is dark now. */
export function isDark() {
  const chosen = document.documentElement.style.colorScheme;
  return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}

/** Sets up the switch; `changed` is called after every change, also one of the system's. */
export function themeSwitch(button, changed) {
  const tell = () => {
    button.textContent = isDark() ? 'Light' : 'Dark';
    changed();
  };
  button.addEventListener('click', () => {
    document.documentElement.style.colorScheme = isDark() ? 'light' : 'dark';
    tell();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', tell);
  tell();
}
