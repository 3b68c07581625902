// Two pictures over each other: a kept one, the user's own, or that of a second time, over the one that is drawn; by a slider, or blinking.

import { bitmapOf, renderPlane } from './server.js';
import { Stage } from './stage.js';
import { mjdOf } from './time.js';

const $ = id => document.getElementById(id);
const BLINK_TIME = 600; // ms: below three flashes a second (WCAG 2.3.1)

export class Compare {
    #blinking = 0;
    #abort = new AbortController();
    #frame = null;

    constructor(stage, onProblem) {
        Object.assign(this, { stage, onProblem });
        $('keep').addEventListener('click', () => this.#show(stage.image, `Kept: ${$('status').textContent}`));
        $('compare-file').addEventListener('change', event => event.target.files[0] && this.#open(event.target.files[0]));
        $('compare-slider').addEventListener('input', () => this.#clip());
        $('compare-clear').addEventListener('click', () => this.#clear());
        $('second-time').addEventListener('change', () => this.know(this.#frame));
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

    /** Draws the frame at rest at the second time too, if there is one, and lays it over the left part. */
    async know(frame) {
        this.#abort.abort();
        this.#abort = new AbortController();
        this.#frame = frame;
        const text = $('second-time').value.trim();
        const mjd = text ? mjdOf(text.replace(' ', 'T')) : null;
        $('second-time').setCustomValidity(text && mjd === null ? 'A time as 2010-04-28T00:00:00Z' : '');
        if (!frame || mjd === null) {
            if ($('compare-name').dataset.isTime) {
                this.#clear();
            }
            return;
        }
        const { signal } = this.#abort;
        try {
            const state = [mjd, ...frame['fixed-state'].slice(1)];
            const image = await renderPlane({ ...frame, 'fixed-state': state }, signal);
            if (!signal.aborted) {
                Stage.paintGrey(this.stage.other, image);
                this.#shown(`Left of the line: ${text}`);
                $('compare-name').dataset.isTime = 'yes';
            }
        } catch (error) {
            if (!signal.aborted) {
                if ($('compare-name').dataset.isTime) {
                    this.#clear(); // the picture of another time
                    $('second-time').value = text;
                }
                this.onProblem(error.message);
            }
        }
    }

    /** The picture of a second time belongs to another view. */
    forget() {
        this.#abort.abort();
        if ($('compare-name').dataset.isTime) {
            this.stage.other.hidden = true;
        }
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
        $('second-time').value = '';
        this.#shown(name);
    }

    #shown(name) {
        this.stage.other.hidden = false;
        $('compare-name').textContent = name;
        delete $('compare-name').dataset.isTime;
        this.#enable(true);
        this.#clip();
    }

    #clear() {
        if (this.#blinking) {
            this.toggleBlink();
        }
        this.stage.other.hidden = true;
        $('compare-name').textContent = '';
        $('compare-file').value = $('second-time').value = '';
        delete $('compare-name').dataset.isTime;
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
        this.stage.picture.style.setProperty('--cut', `${part}%`);
        this.stage.picture.classList.toggle('cut', !this.stage.other.hidden && part < 100 && part > 0);
    }
}
