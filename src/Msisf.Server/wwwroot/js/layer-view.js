// The layer that is shown as colours over the picture, with its scale.

import { LAYERS, colouredLayer, showScale } from './layers.js';
import { renderPlane } from './server.js';
import { Stage } from './stage.js';

const $ = id => document.getElementById(id);

export class LayerView {
    #abort = new AbortController();
    #frame = null;

    constructor(stage, onProblem) {
        Object.assign(this, { stage, onProblem });
        this.choice = $('layer-choice');
        this.choice.append(...Object.entries(LAYERS).map(([name, { label }]) => new Option(label, name)));
        this.choice.addEventListener('change', () => this.show(this.#frame));
        $('layer-opacity').addEventListener('input', () => this.#setOpacity());
        this.#setOpacity();
    }

    /** The name of the layer chosen, or an empty text. */
    get name() {
        return this.choice.value;
    }

    /** Chooses the next layer of the list, or none after the last. */
    next() {
        this.choice.selectedIndex = (this.choice.selectedIndex + 1) % this.choice.length;
        this.show(this.#frame);
    }

    /** Takes the colours away: the picture is of another view. */
    hide() {
        this.#abort.abort();
        this.#frame = null;
        this.stage.layer.hidden = true;
        $('scale').hidden = true;
    }

    /** Colours a frame, the one at rest. */
    async show(frame) {
        this.hide();
        this.#frame = frame;
        const name = this.name;
        if (!name || !frame) {
            return;
        }
        this.#abort = new AbortController();
        const { signal } = this.#abort;
        try {
            const plane = await renderPlane({ ...frame, samples: 1, layers: [name] }, signal);
            if (signal.aborted) {
                return;
            }
            const { pixels, range } = colouredLayer(name, plane);
            Stage.paint(this.stage.layer, pixels);
            showScale($('scale'), name, range);
            this.stage.layer.hidden = false;
            $('scale').hidden = false;
        } catch (error) {
            if (!signal.aborted) {
                this.onProblem(error.message);
            }
        }
    }

    #setOpacity() {
        this.stage.layer.style.opacity = $('layer-opacity').valueAsNumber / 100;
    }
}
