// Which marks lie over the picture, and the fields that switch them.

import { drawCraters, drawLandmarks, drawNames, drawRims } from './features.js';
import { Grid } from './grid.js';
import { Overlay } from './overlay.js';
import { LETTERS } from './readings.js';
import { getJson, renderMeta } from './server.js';
import { drawTrajectory } from './trajectory.js';

const $ = id => document.getElementById(id);

export class Marks {
    #craters = [];
    #truth = null;
    #frame = null;
    #abort = new AbortController();

    /**
     * @param look answers what there is to mark: {shown, isAtRest, sunPosition, readings, crosshair, names, states, contours}.
     * @param onPins gets where the pins are in the page, before labels are placed.
     */
    constructor(stage, look, onPins, onProblem) {
        Object.assign(this, { stage, look, onPins, onProblem });
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
        const places = readings.pins.map(({ position }) => position);
        this.onPins(places.map(place => overlay.at(place)).filter(Boolean).map(place => this.stage.onPage(place)));
        overlay.keepOut(this.stage.covered);
        if (isAtRest) {
            contours.draw(overlay);
        }
        drawTrajectory(overlay, states, shown.size, shown.view.fov);
        for (const [index, place] of places.entries()) {
            if (index > 0) {
                overlay.drawWay(places[index - 1], place);
            }
        }
        if (places.length > 2) {
            overlay.drawWay(places.at(-1), places[0], true);
        }
        for (const [index, place] of places.entries()) {
            overlay.drawPin(place, LETTERS[index]);
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
        const { here } = readings;
        if (isAtRest && here && here.illumination_direction !== null && $('show-arrow').checked) {
            overlay.drawArrow(here.pixel, here.illumination_direction);
        }
        if (crosshair) {
            overlay.drawCrosshair(crosshair);
        }
    }
}
