// Where the Sun is, as the server computes it, for the time that is looked at.

import { cameraOf, meetSphere, placeOf, rayThrough, scale, sunAt } from './geometry.js';
import { getJson, LostError } from './server.js';
import { degrees, latitudeText } from './text.js';
import { calendarOf } from './time.js';

const LAST_MJD = 1e6; // later ones look like Julian Dates to the server

const $ = id => document.getElementById(id);

export class Sun {
    #mjd = null;
    #isAsking = false;

    #known = null;

    /**
     * @param onChange is called when the Sun of another time is known.
     * @param onRefused gets the server's words about a time that its kernels do not cover, and the last one that they do; null for none.
     */
    constructor(onChange, onRefused) {
        Object.assign(this, { onChange, onRefused });
        /** The Sun's position, m, MOON_ME, and its sub-solar point; null before it is known. */
        this.position = null;
        this.subsolar = null;
    }

    /** Asks for the Sun of a time: of the times that come while one is asked, only the newest counts. */
    async at(mjd) {
        if (mjd === this.#mjd && this.position) {
            return;
        }
        this.#mjd = mjd;
        if (this.#isAsking) {
            return;
        }
        this.#isAsking = true;
        for (let asked = null; asked !== this.#mjd;) {
            asked = this.#mjd;
            let sun = null;
            let refused = null;
            try {
                sun = await getJson(asked > LAST_MJD ? `/v1/sun?utc=${calendarOf(asked)}Z` : `/v1/sun?mjd=${asked}`);
                this.#known = asked;
            } catch (error) {
                refused = error instanceof LostError ? null : error.message;
            }
            this.position = sun && scale(sun.direction, sun.distance);
            this.subsolar = sun?.sub_solar_point ?? null;
            this.onChange();
            if (refused && asked === this.#mjd) {
                this.onRefused(refused, this.#known);
            }
        }
        this.#isAsking = false;
    }

    /** Shows where the Sun stands over the ground in the middle of the picture. */
    showOver({ view, size }) {
        const camera = cameraOf(view);
        const middle = [(size.width + 1) / 2, (size.height + 1) / 2];
        const centre = meetSphere(camera.position, rayThrough(camera, { ...size, fov: view.fov }, middle));
        const over = centre && this.position ? sunAt(centre, this.position) : null;
        const placeText = ({ latitude, longitude }) => `${latitudeText(latitude)}, ${degrees(longitude, 6)} E`;
        $('sun-elevation').textContent = over ? degrees(over.elevation) : '–';
        $('sun-azimuth').textContent = over ? degrees(over.azimuth) : '–';
        $('sun-elevation').title = centre ? `At ${placeText(placeOf(centre))}` : '';
        $('sub-solar').textContent = this.subsolar ? placeText(this.subsolar) : '–';
    }
}
