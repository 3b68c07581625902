// The picture: while the camera moves the last exact image as it looks from there, and exact ones as they come; in full size when it
// rests, then with more samples; or a stored one.

import { viewOf } from './geometry.js';
import { ImageStream } from './stream.js';
import { LostError, renderPlane } from './server.js';
import { Stage } from './stage.js';
import { picturesText, samplesText } from './text.js';
import { Warp } from './warp.js';

const REST_AFTER = 80; // ms without a movement

/** Pixels of a picture that is drawn once, with all its samples: twice would take longer than anybody waits. */
const LARGE = 4e6;

/** Samples of a whole picture: more take longer than anybody waits to look around. As many as are needed is not many. */
const MOST_SAMPLES = 16e6;

const DEPTH = { layers: ['depth'], 'layers-precision': 'single' };

/** Frames are drawn within a sixtieth of a second if the picture that moves has so many pixels or fewer. */
const LEAST_WARP = 400; // px, of the longer side
const MOST_WARP = 1920;
const SLOW = 17.6; // ms between two pictures
const QUICK = 17;

/** As many samples a pixel, a square number, as are wanted and as a picture of this size can have. */
const samplesFor = (wanted, { width, height }) => (wanted === 'auto' ? wanted
    : Math.max(1, Math.floor(Math.sqrt(Math.min(wanted, MOST_SAMPLES / (width * height))))) ** 2);

export class Picture {
    #stream;
    #warp;
    #timer = 0;
    #request = 0;
    #abort = new AbortController();
    #times = [];
    #exact = [];
    #longest = 1280;
    #saidAt = 0;

    /**
     * @param isMoving says whether keys or fingers move the camera.
     * @param hooks onShown() after each picture, onRest(frame) when the one at rest is there, onStatus(text), onNotice(text or null),
     * onWork(whether the server draws), onLost() when the server does not answer.
     */
    constructor(stage, state, isMoving, hooks) {
        Object.assign(this, { stage, state, isMoving, hooks });
        this.#stream = new ImageStream(
            (image, depth, milliseconds) => this.#moved(image, depth, milliseconds), hooks.onNotice, hooks.onLost);
        this.#warp = new Warp(stage.warp, () => {
            stage.warp.hidden = true;
            this.draw();
        });
        /** What is on the screen: the view, the size by which pixels are counted, and the frame as the server takes it. */
        this.shown = null;
        this.isStored = false;
    }

    /** Draws the state anew. */
    draw() {
        this.#abort.abort();
        clearTimeout(this.#timer);
        this.isStored = false;
        this.isAtRest = false;
        this.hooks.onWork(true);
        this.stage.setSize(this.state.size);
        const frame = this.state.frame(this.state.movingSize);
        this.#stream.show(this.#canWarp ? { ...frame, ...DEPTH } : frame);
        this.#warpSoon();
        this.#timer = setTimeout(() => this.#rest(), REST_AFTER);
    }

    /** Shows a stored picture of a frame in place of a drawn one, until the camera moves. */
    showStored(bitmap, frame, text) {
        this.#abort.abort();
        clearTimeout(this.#timer);
        this.#stream.rest();
        this.#warp.drop();
        this.isStored = true;
        this.stage.setSize(this.state.size);
        this.stage.showPicture(this.stage.image, bitmap);
        this.#show(this.state.view, this.state.size, frame);
        this.isAtRest = true;
        this.stage.warp.hidden = true;
        this.hooks.onWork(false);
        this.hooks.onStatus(text);
        this.hooks.onRest(frame);
    }

    /** The image of a lens does not warp as that of a pinhole. */
    get #canWarp() {
        return this.#warp.isReady && !this.state.own.camera;
    }

    #show(view, size, frame) {
        this.shown = { view, size, frame };
        this.hooks.onShown();
    }

    #warpSoon() {
        if (this.#request === 0 && this.#canWarp && this.#warp.hasSource) {
            this.#request = requestAnimationFrame(() => {
                this.#request = 0;
                if (!this.isAtRest && !this.isStored && this.#canWarp && this.#warp.hasSource) {
                    this.#warpNow();
                }
            });
        }
    }

    #warpNow() {
        const { view, size } = this.state;
        const factor = Math.min(1, this.#longest / Math.max(size.width, size.height));
        const [width, height] = [size.width, size.height].map(side => Math.max(1, Math.round(side * factor)));
        this.#warp.draw(view, { width, height });
        this.stage.warp.hidden = false;
        this.#show(view, size, null);
        this.#count(size);
    }

    /** Counts the pictures of the last second, and fits their size to what the machine can draw. */
    #count({ width, height }) {
        const now = performance.now();
        this.#times = [...this.#times.filter(time => now - time < 1000), now];
        if (now - this.#saidAt > 250) {
            this.#saidAt = now;
            const exact = this.#exact.filter(time => now - time < 1000).length;
            this.hooks.onStatus(`Moving: ${width} × ${height}, ${picturesText(this.#times.length)} in the last second, `
                + `${exact} of them exact.`);
            const recent = this.#times.slice(-10);
            const between = recent.length > 2 ? (now - recent[0]) / (recent.length - 1) : 2 * SLOW;
            this.#longest = Math.min(Math.max(this.#longest * (between > SLOW ? 0.85 : between < QUICK ? 1.1 : 1), LEAST_WARP), MOST_WARP);
        }
    }

    #moved(image, depth, milliseconds) {
        if (this.isStored || this.isAtRest) {
            return;
        }
        const { fov = this.state.view.fov, 'fixed-state': state } = this.#stream.drawn;
        const view = { ...viewOf(state), fov };
        this.#exact = [...this.#exact.slice(-60), performance.now()];
        if (depth && this.#canWarp) {
            this.#warp.take(image, depth, view);
            this.#warpSoon();
            return;
        }
        Stage.paintGrey(this.stage.image, image);
        this.#show(view, this.state.size, null);
        const now = performance.now();
        this.#times = [...this.#times.filter(time => now - time < 1000), now];
        this.hooks.onStatus(`Moving: ${image.width} × ${image.height}, ${picturesText(this.#times.length)} in the last second, `
            + `${Math.round(milliseconds)} ms each.`);
    }

    /** Full size with one sample a pixel, then with as many as are wanted; a large one with these at once. */
    async #rest() {
        if (this.isMoving()) {
            this.#timer = setTimeout(() => this.#rest(), REST_AFTER);
            return;
        }
        if (this.#canWarp && this.#warp.hasSource) {
            this.#stream.rest(); // a small picture more would only be in the way of the whole one
        }
        this.#abort = new AbortController();
        const { signal } = this.#abort;
        const [view, size] = [this.state.view, this.state.size];
        const truth = this.state.frame(size);
        const most = samplesFor(this.state.picture.samples, size);
        try {
            const isOnce = most === 1 || size.width * size.height > LARGE;
            for (const [step, samples] of (isOnce ? [most] : [1, most]).entries()) {
                const start = performance.now();
                const words = `${size.width} × ${size.height}, ${samplesText(samples)}`;
                this.hooks.onStatus(`Drawing: ${words}.`);
                const image = await renderPlane({ ...truth, samples }, signal);
                if (signal.aborted) {
                    return;
                }
                this.#stream.rest();
                this.isAtRest = true;
                Stage.paintGrey(this.stage.image, image);
                this.stage.warp.hidden = true;
                this.#show(view, size, truth);
                this.hooks.onNotice(null);
                this.hooks.onStatus(`At rest: ${words}, ${Math.round(performance.now() - start)} ms.`);
                if (step === 0) {
                    this.hooks.onRest(truth);
                    this.#prepareWarp(image, view, signal);
                }
            }
            this.hooks.onWork(false);
        } catch (error) {
            if (!signal.aborted) {
                this.hooks.onWork(false);
                this.hooks.onStatus('Not drawn.');
                if (error instanceof LostError) {
                    this.hooks.onLost();
                } else {
                    this.hooks.onNotice(error.message);
                }
            }
        }
    }

    /** The next movement starts from the picture at rest. */
    async #prepareWarp(image, view, signal) {
        if (this.#canWarp) {
            const depth = await renderPlane({ ...this.state.frame(this.state.movingSize), ...DEPTH }, signal).catch(() => null);
            if (depth && !signal.aborted) {
                this.#warp.take(image, depth, view);
            }
        }
    }
}
