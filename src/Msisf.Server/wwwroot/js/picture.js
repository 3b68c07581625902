// The picture: small and quick while the camera moves, in full size when it rests, then with more samples; or a stored one.

import { viewOf } from './geometry.js';
import { ImageStream } from './stream.js';
import { renderPlane } from './server.js';
import { Stage } from './stage.js';

const REST_AFTER = 250; // ms without a movement

/** Samples of a whole picture: more take longer than anybody waits to look around. */
const MOST_SAMPLES = 16e6;

/** As many samples a pixel, a square number, as are wanted and as a picture of this size can have. */
const samplesFor = (wanted, { width, height }) =>
    Math.max(1, Math.floor(Math.sqrt(Math.min(wanted, MOST_SAMPLES / (width * height))))) ** 2;

export class Picture {
    #stream;
    #timer = 0;
    #abort = new AbortController();
    #times = [];

    /**
     * @param isMoving says whether keys or fingers move the camera.
     * @param hooks onShown() after each picture, onRest(frame) when the one at rest is there, onStatus(text), onNotice(text or null).
     */
    constructor(stage, state, isMoving, hooks) {
        Object.assign(this, { stage, state, isMoving, hooks });
        this.#stream = new ImageStream((image, milliseconds) => this.#moved(image, milliseconds), hooks.onNotice);
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
        this.stage.setSize(this.state.size);
        this.#stream.show(this.state.frame(this.state.movingSize));
        this.#timer = setTimeout(() => this.#rest(), REST_AFTER);
    }

    /** Shows a stored picture of a frame in place of a drawn one, until the camera moves. */
    showStored(bitmap, frame, text) {
        this.#abort.abort();
        clearTimeout(this.#timer);
        this.#stream.rest();
        this.isStored = true;
        this.stage.setSize(this.state.size);
        this.stage.showPicture(this.stage.image, bitmap);
        this.#show(this.state.view, this.state.size, frame);
        this.isAtRest = true;
        this.hooks.onStatus(text);
        this.hooks.onRest(frame);
    }

    #show(view, size, frame) {
        this.shown = { view, size, frame };
        this.hooks.onShown();
    }

    #moved(image, milliseconds) {
        if (this.isStored || this.isAtRest) {
            return;
        }
        Stage.paintGrey(this.stage.image, image);
        const { fov = this.state.view.fov, 'fixed-state': state } = this.#stream.drawn;
        this.#show({ ...viewOf(state), fov }, this.state.size, null);
        const now = performance.now();
        this.#times = [...this.#times.filter(time => now - time < 1000), now];
        this.hooks.onStatus(`Moving: ${image.width} × ${image.height}, ${this.#times.length} pictures in the last second, `
            + `${Math.round(milliseconds)} ms each.`);
    }

    /** Full size with one sample a pixel, then with as many as are wanted. */
    async #rest() {
        if (this.isMoving()) {
            this.#timer = setTimeout(() => this.#rest(), REST_AFTER);
            return;
        }
        this.#abort = new AbortController();
        const { signal } = this.#abort;
        const [view, size] = [this.state.view, this.state.size];
        const truth = this.state.frame(size);
        const most = samplesFor(this.state.picture.samples, size);
        try {
            for (const samples of most > 1 ? [1, most] : [1]) {
                const start = performance.now();
                const words = `${size.width} × ${size.height}, ${samples} ${samples === 1 ? 'sample' : 'samples'} a pixel`;
                this.hooks.onStatus(`Drawing: ${words}.`);
                const image = await renderPlane({ ...truth, samples }, signal);
                if (signal.aborted) {
                    return;
                }
                this.#stream.rest();
                this.isAtRest = true;
                Stage.paintGrey(this.stage.image, image);
                this.#show(view, size, truth);
                this.hooks.onNotice(null);
                this.hooks.onStatus(`At rest: ${words}, ${Math.round(performance.now() - start)} ms.`);
                if (samples === 1) {
                    this.hooks.onRest(truth);
                }
            }
        } catch (error) {
            if (!signal.aborted) {
                this.hooks.onStatus('Not drawn.');
                this.hooks.onNotice(error.message);
            }
        }
    }
}
