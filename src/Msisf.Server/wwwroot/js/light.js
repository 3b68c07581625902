// When the place in the middle of the picture is in the light next, with the horizons of the terrain around it.

import { placeOf, sunAt } from './geometry.js';
import { centreOf } from './models.js';
import { getJson, readLight } from './server.js';

const $ = id => document.getElementById(id);
const AHEAD = 15; // days to the middle of the time that is looked at: it begins now, and is longer than a night
const HIGH = 5; // degrees: below a lower Sun most of the ground is black

/**
 * The first of some times at which at least half the Sun is in view and it is 5 degrees high; where it stays lower, the one in the light
 * at which it is highest. Pure.
 * @param parts of the Sun that are in view, 0 to 1; @param elevations of the Sun, degrees, at the same times.
 * @returns an index; -1 without any light.
 */
export function firstLight(parts, elevations) {
    const lit = [...parts.keys()].filter(index => parts[index] >= 0.5);
    return lit.find(index => elevations[index] >= HIGH)
        ?? lit.reduce((best, index) => (best < 0 || elevations[index] > elevations[best] ? index : best), -1);
}

export class NextLight {
    /** @param frame answers the frame that is looked at; @param onTime gets the MJD to go to. */
    constructor(state, frame, onTime, onNotice) {
        Object.assign(this, { state, frame, onTime, onNotice });
        $('next-light').addEventListener('click', async () => {
            $('next-light').disabled = true;
            await this.#go().catch(error => onNotice(error.message));
            $('next-light').disabled = false;
        });
    }

    /** Offers it where the Sun has set; without a Sun there is nothing in the middle of the picture. */
    offer(sun) {
        $('next-light').hidden = !(sun && sun.elevation < 0);
    }

    async #go() {
        const { view, size } = this.state;
        const centre = centreOf(view, size);
        const { latitude, longitude } = placeOf(centre);
        const frame = this.frame();
        const [mjd, ...pose] = frame['fixed-state'];
        const { from, places: [{ parts }] } = await readLight({ ...frame, 'fixed-state': [mjd + AHEAD, ...pose] }, [[latitude, longitude]]);
        const to = from + (parts.length - 1) / 24;
        const { positions } = await getJson(`/v1/sun/path?from=${from}&to=${to}&count=${parts.length}`);
        const index = firstLight(parts, positions.map(position => sunAt(centre, position).elevation));
        if (index < 0) {
            this.onNotice(`The Sun does not reach the middle of the picture within ${2 * AHEAD} days.`);
        } else {
            this.onTime(from + index / 24);
        }
    }
}
