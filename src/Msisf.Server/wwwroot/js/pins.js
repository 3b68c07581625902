// What the pins are asked: the heights of the ground between them, and the month of light at the first.

import { angleBetween, combine, normalize, placeOf } from './geometry.js';
import { plot } from './plot.js';
import { LETTERS, pathLength } from './readings.js';
import { readGround, readLight } from './server.js';
import { save } from './takeaway.js';
import { fixed, lengthText } from './text.js';
import { calendarOf } from './time.js';

const $ = id => document.getElementById(id);
const COUNT = 401;
const HOURS = 24;

/** The place at a part of the shortest way over the sphere from one point to another. */
function placeBetween(from, to, part) {
    const [a, b] = [normalize(from), normalize(to)];
    const angle = angleBetween(a, b) * Math.PI / 180;
    const parts = angle < 1e-9 ? [1 - part, part] : [Math.sin((1 - part) * angle), Math.sin(part * angle)];
    const { latitude, longitude } = placeOf(combine([a, parts[0]], [b, parts[1]]));
    return [latitude, longitude];
}

/** m: how far along the path each of its points is. */
const distancesOf = points => points.map((_, index) => pathLength(points.slice(0, index + 1)));

/** Places along great circles from point to point, at even distances: latitude and longitude. Pure. */
export function wayAlong(points, count) {
    const ends = distancesOf(points);
    return Array.from({ length: count }, (_, index) => {
        const along = ends.at(-1) * index / (count - 1);
        const found = ends.findIndex((end, point) => point > 0 && end >= along);
        const leg = found < 0 ? ends.length - 1 : found; // the last place may be behind the end by a rounding
        return placeBetween(points[leg - 1], points[leg], (along - ends[leg - 1]) / (ends[leg] - ends[leg - 1] || 1));
    });
}

/** What a plot is of: the places of pins. */
const keyOf = pins => pins.map(({ position }) => String(position)).join(' ');

/** A profile as CSV. */
export const profileCsv = rows => ['distance_m,latitude_deg,longitude_deg,height_m',
    ...rows.map(row => row.join(','))].join('\n').concat('\n');

export class Pins {
    #rows = [];

    /** @param pins answers the readings of the pins; @param frame the frame that is looked at. */
    constructor(pins, frame, onProblem) {
        Object.assign(this, { pins, frame });
        const doing = (button, work) => $(button).addEventListener('click', async () => {
            $(button).disabled = true;
            await work().catch(error => onProblem(error.message));
            this.show();
        });
        doing('profile', () => this.#profile());
        doing('light', () => this.#light());
        $('profile-save').addEventListener('click', () => save(new Blob([profileCsv(this.#rows)], { type: 'text/csv' }), 'profile.csv'));
    }

    /** Enables what the pins allow; what belongs to other pins goes. */
    show() {
        const pins = this.pins();
        $('profile').disabled = pins.length < 2;
        $('profile').textContent = `Profile from A to ${LETTERS[Math.max(pins.length - 1, 1)]}`;
        $('light').disabled = pins.length === 0;
        const [profileOf, lightOf] = [keyOf(pins), keyOf(pins.slice(0, 1))];
        if ($('profile-plot').dataset.of !== profileOf) {
            $('profile-plot').hidden = true;
            $('profile-save').disabled = true;
        }
        if ($('light-plot').dataset.of !== lightOf) {
            $('light-plot').hidden = true;
        }
    }

    async #profile() {
        const pins = this.pins();
        const points = pins.map(({ position }) => position);
        const places = wayAlong(points, COUNT);
        const heights = await readGround(this.frame(), places);
        const ends = distancesOf(points);
        const all = ends.at(-1);
        const last = LETTERS[pins.length - 1];
        this.#rows = places.map(([latitude, longitude], index) => [all * index / (COUNT - 1), latitude, longitude, heights[index]]);
        const [least, most] = [Math.min(...heights), Math.max(...heights)];
        $('profile-plot').hidden = false;
        $('profile-plot').dataset.of = keyOf(pins);
        plot($('profile-plot').querySelector('canvas'), this.#rows.map(([along, , , height]) => [along, height]), {
            range: [least, most], yTexts: [`lowest ${fixed(least, 0)} m`, `highest ${fixed(most, 0)} m`],
            xTexts: ['A', `${last}, ${lengthText(all)}`], fill: 'rgb(142 197 255 / 0.2)', marks: ends.slice(1, -1),
        });
        $('profile-plot').querySelector('figcaption').textContent = `Height of the ground at ${COUNT} places from A to ${last}; `
            + `${fixed(most - least, 0)} m between the lowest and the highest.`;
        $('profile-save').disabled = false;
        $('profile-plot').scrollIntoView({ block: 'nearest' });
    }

    async #light() {
        const [A] = this.pins();
        const frame = this.frame();
        const { from, places: [place] } = await readLight(frame, [[A.latitude, A.longitude]]);
        const hours = place.parts.map((part, index) => [from + index / HOURS, part]);
        $('light-plot').hidden = false;
        $('light-plot').dataset.of = keyOf([A]);
        plot($('light-plot').querySelector('canvas'), hours, {
            range: [0, 1], yTexts: ['', 'part of the Sun in view'], marks: [frame['fixed-state'][0]], colour: '#ffc46b',
            fill: 'rgb(255 196 107 / 0.25)',
            xTexts: [calendarOf(from).slice(0, 10), calendarOf(hours.at(-1)[0]).slice(0, 10)],
        });
        $('light-plot').querySelector('figcaption').textContent = `At A the Sun is in view for ${fixed(100 * place.lit, 1)} % of 30 days; `
            + `longest light ${place.longest_light} h, longest dark ${place.longest_dark} h.`;
        $('light-plot').scrollIntoView({ block: 'nearest' });
    }
}
