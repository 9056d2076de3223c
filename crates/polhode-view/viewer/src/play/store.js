// The text that was typed, kept by the browser: a page that is closed, or stops, loses none of it.

const KEY = 'polhode-playground-text';

/** Keeps a text that was typed in the page of this scene; a browser that keeps nothing is no failure. */
export function keepText(page, text) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ page, text }));
  } catch {
    // The text still stands in the page.
  }
}

/** The text that was typed in the page of this scene, or null. */
export function keptText(page) {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY));
    return kept?.page === page && typeof kept.text === 'string' ? kept.text : null;
  } catch {
    return null;
  }
}
