// Where the Sun is, as the server computes it, for the time that is looked at.

import { scale } from './geometry.js';
import { getJson } from './server.js';

export class Sun {
    #mjd = null;
    #isAsking = false;

    /** @param onChange is called when the Sun of another time is known. */
    constructor(onChange) {
        this.onChange = onChange;
        /** The Sun's position, m, MOON_ME, and its sub-solar point; null before it is known. */
        this.position = null;
        this.subsolar = null;
    }

    /** Asks for the Sun of a time: of the times that come while one is asked, only the newest counts. */
    async at(mjd) {
        this.#mjd = mjd;
        if (this.#isAsking) {
            return;
        }
        this.#isAsking = true;
        for (let asked = null; asked !== this.#mjd;) {
            asked = this.#mjd;
            const sun = await getJson(`/v1/sun?mjd=${asked}`).catch(() => null);
            this.position = sun && scale(sun.direction, sun.distance);
            this.subsolar = sun?.sub_solar_point ?? null;
            this.onChange();
        }
        this.#isAsking = false;
    }
}
