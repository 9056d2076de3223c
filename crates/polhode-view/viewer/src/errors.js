// An error whose message is written for the reader of the page.

/** Data of the page that cannot be shown; the message says in words what is wrong. */
export class PageError extends Error {}

/** The words to show for any error: the message of a PageError, and a plain sentence around every other one. */
export function wordsOf(error) {
  if (error instanceof PageError) return error.message;
  return `The viewer stopped because of a mistake of its own: ${error?.message ?? error}.`;
}
