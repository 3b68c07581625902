// Which marks lie over the picture, and the fields that switch them.

import { Overlay } from './overlay.js';
import { getJson } from './server.js';

const $ = id => document.getElementById(id);

export class Marks {
    #craters = [];

    /** @param look answers what there is to mark: {shown, isAtRest, sunPosition, readings, crosshair}. */
    constructor(stage, look, onProblem) {
        Object.assign(this, { stage, look });
        for (const id of ['show-grid', 'show-terminator', 'show-arrow']) {
            $(id).addEventListener('change', () => this.draw());
        }
        $('catalogue').addEventListener('change', event => this.#open(event.target.value).catch(error => onProblem(error.message)));
    }

    /** Switches a mark by its field. */
    toggle(id) {
        $(id).checked = !$(id).checked;
        this.draw();
    }

    async #open(name) {
        this.#craters = name ? (await getJson(`/v1/catalogues/${encodeURIComponent(name)}`)).craters : [];
        this.draw();
    }

    draw() {
        const { shown, isAtRest, sunPosition, readings, crosshair } = this.look();
        if (!shown) {
            return;
        }
        const overlay = new Overlay(this.stage.overlay, shown.view, shown.size);
        const pins = ['A', 'B'].filter(letter => readings.get(letter));
        if (pins.length === 2) {
            overlay.drawWay(...pins.map(letter => readings.get(letter).position));
        }
        for (const letter of pins) {
            overlay.drawPin(readings.get(letter).position, letter);
        }
        if ($('show-grid').checked) {
            overlay.drawGrid();
        }
        if ($('show-terminator').checked && sunPosition) {
            overlay.drawTerminator(sunPosition);
        }
        overlay.drawCraters(this.#craters);
        const here = readings.get('here');
        if (isAtRest && here && here.illumination_direction !== null && $('show-arrow').checked) {
            overlay.drawArrow(here.pixel, here.illumination_direction);
        }
        if (crosshair) {
            overlay.drawCrosshair(crosshair);
        }
    }
}
