// Which marks lie over the picture, and the fields that switch them.

import { drawCraters, drawLandmarks, drawNames, drawRims } from './features.js';
import { Grid } from './grid.js';
import { Overlay } from './overlay.js';
import { getJson, renderMeta } from './server.js';
import { drawTrajectory } from './trajectory.js';

const $ = id => document.getElementById(id);

export class Marks {
    #craters = [];
    #truth = null;
    #frame = null;
    #abort = new AbortController();

    /** @param look answers what there is to mark: {shown, isAtRest, sunPosition, readings, crosshair, names, states, contours}. */
    constructor(stage, look, onProblem) {
        Object.assign(this, { stage, look, onProblem });
        for (const id of ['show-grid', 'show-terminator', 'show-arrow', 'show-names', 'show-trajectory', 'longitudes']) {
            $(id).addEventListener('change', () => this.draw());
        }
        $('catalogue').addEventListener('change', event => this.#open(event.target.value).catch(error => onProblem(error.message)));
        for (const id of ['catalogue', 'landmarks']) {
            $(id).addEventListener('change', () => this.know(this.#frame));
        }
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

    /** Asks where the craters and landmarks of a frame, the one at rest, are: as its meta file has them. */
    async know(frame) {
        this.#abort.abort();
        this.#abort = new AbortController();
        const { signal } = this.#abort;
        const [craters, landmarks] = [$('catalogue').value, $('landmarks').value];
        [this.#frame, this.#truth] = [frame, null];
        this.draw();
        if (!frame || !(craters || landmarks)) {
            return;
        }
        try {
            const lists = { ...(craters && { craters, 'crater-size': 15 }), ...(landmarks && { landmarks }) };
            const meta = await renderMeta({ ...frame, samples: 1, ...lists }, signal);
            this.#truth = {
                craters: craters ? meta.CraterInformation?.Crater ?? [] : null,
                landmarks: meta.LandmarkInformation?.Landmark ?? [],
            };
            this.draw();
        } catch (error) {
            if (error.name !== 'AbortError') {
                this.onProblem(error.message);
            }
        }
    }

    draw() {
        const { shown, isAtRest, sunPosition, readings, crosshair, names, states, contours } = this.look();
        if (!shown) {
            return;
        }
        const overlay = new Overlay(this.stage.overlay, shown.view, shown.size);
        if (isAtRest) {
            contours.draw(overlay);
        }
        drawTrajectory(overlay, states, shown.size, shown.view.fov);
        const pins = ['A', 'B'].filter(letter => readings.get(letter));
        if (pins.length === 2) {
            overlay.drawWay(...pins.map(letter => readings.get(letter).position));
        }
        for (const letter of pins) {
            overlay.drawPin(readings.get(letter).position, letter);
        }
        if ($('show-grid').checked) {
            new Grid(overlay, $('longitudes').value === '180').draw();
        }
        if ($('show-terminator').checked && sunPosition) {
            overlay.drawTerminator(sunPosition);
        }
        const truth = isAtRest && this.#truth;
        drawLandmarks(overlay, truth ? truth.landmarks : []);
        if (truth?.craters) {
            drawRims(overlay, truth.craters);
        } else {
            drawCraters(overlay, this.#craters);
        }
        if ($('show-names').checked) {
            drawNames(overlay, names, sunPosition);
        }
        const here = readings.get('here');
        if (isAtRest && here && here.illumination_direction !== null && $('show-arrow').checked) {
            overlay.drawArrow(here.pixel, here.illumination_direction);
        }
        if (crosshair) {
            overlay.drawCrosshair(crosshair);
        }
    }
}
