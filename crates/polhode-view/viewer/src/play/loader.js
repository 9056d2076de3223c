// Unpacks the script of the page and runs it.

import { wordsOf } from '../errors.js';
import { packedText } from './packed.js';

packedText('polhode-script', 'The script of the page').then(
  (text) => {
    const script = document.createElement('script');
    script.textContent = text;
    document.body.append(script);
  },
  (error) => {
    const message = document.getElementById('message');
    message.textContent = wordsOf(error);
    message.hidden = false;
    document.body.classList.add('failed');
  },
);
