// What one takes along: texts to copy, files to save.

import { batchLineOf, commandLine, python } from './commands.js';
import { copy } from './copy.js';
import { LAYERS } from './layers.js';
import { renderFile } from './server.js';

const $ = id => document.getElementById(id);

/** Saves a file to the browser's downloads. */
export function save(blob, name) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

export class TakeAway {
    /** @param frame answers the frame that is looked at, @param models the server's models. */
    constructor(frame, models, onProblem) {
        Object.assign(this, { frame, models, onProblem });
        $('copy-command').addEventListener('click', () => copy(commandLine(frame(), models())));
        $('copy-batch').addEventListener('click', () => copy(batchLineOf(frame())));
        $('copy-python').addEventListener('click', () => copy(python(frame(), location.origin)));
        $('save-image').addEventListener('click', event => this.#save(event.target, {}, 'image/png', 'moon.png'));
        $('save-deep').addEventListener('click', event => this.#save(event.target, { 'bit-depth': 16 }, 'image/png', 'moon-16.png'));
        $('save-fits').addEventListener('click', event => this.#save(
            event.target, { layers: ['radiance-factor'] }, 'application/fits', 'moon.fits'));
        $('save-meta').addEventListener('click', event => this.#save(
            event.target, { surface: 'terrain', samples: 1 }, 'application/xml', 'moon.xml'));
        $('save-layers').addEventListener('click', event => this.#save(
            event.target, { layers: Object.keys(LAYERS), samples: 1 }, 'application/fits', 'layers.fits'));
    }

    async #save(button, more, kind, name) {
        button.disabled = true;
        try {
            save(await renderFile({ ...this.frame(), ...more }, kind), name);
        } catch (error) {
            this.onProblem(error.message);
        } finally {
            button.disabled = false;
        }
    }
}
