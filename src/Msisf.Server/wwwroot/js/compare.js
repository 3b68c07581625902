// Two pictures over each other: a kept one, or the user's own, over the one that is drawn; by a slider, or blinking.

import { bitmapOf } from './server.js';

const $ = id => document.getElementById(id);
const BLINK_TIME = 600; // ms: below three flashes a second (WCAG 2.3.1)

export class Compare {
    #blinking = 0;

    constructor(stage, onProblem) {
        Object.assign(this, { stage, onProblem });
        $('keep').addEventListener('click', () => this.#show(stage.image, `Kept: ${$('status').textContent}`));
        $('compare-file').addEventListener('change', event => event.target.files[0] && this.#open(event.target.files[0]));
        $('compare-slider').addEventListener('input', () => this.#clip());
        $('compare-clear').addEventListener('click', () => this.#clear());
        $('blink').addEventListener('click', () => this.toggleBlink());
    }

    /** Starts or ends blinking, if there are two pictures. */
    toggleBlink() {
        if ($('blink').disabled) {
            return;
        }
        if (this.#blinking) {
            clearInterval(this.#blinking);
            this.#blinking = 0;
            this.stage.other.hidden = false;
        } else {
            this.#blinking = setInterval(() => this.stage.other.hidden = !this.stage.other.hidden, BLINK_TIME);
        }
        $('blink').setAttribute('aria-pressed', this.#blinking !== 0);
        this.#clip();
    }

    async #open(file) {
        try {
            const bitmap = await bitmapOf(file);
            this.#show(bitmap, `${file.name}: ${bitmap.width} × ${bitmap.height}`);
        } catch {
            this.onProblem(`${file.name} is no image that the browser can read.`);
        }
    }

    #show(bitmap, name) {
        this.stage.showPicture(this.stage.other, bitmap);
        this.stage.other.hidden = false;
        $('compare-name').textContent = name;
        this.#enable(true);
        this.#clip();
    }

    #clear() {
        if (this.#blinking) {
            this.toggleBlink();
        }
        this.stage.other.hidden = true;
        $('compare-name').textContent = '';
        $('compare-file').value = '';
        this.#enable(false);
    }

    #enable(isThere) {
        for (const id of ['compare-clear', 'compare-slider', 'blink']) {
            $(id).disabled = !isThere;
        }
    }

    /** The other picture covers the left part up to the slider; all of it while it blinks. */
    #clip() {
        const part = this.#blinking ? 100 : $('compare-slider').valueAsNumber;
        this.stage.other.style.clipPath = `inset(0 ${100 - part}% 0 0)`;
    }
}
