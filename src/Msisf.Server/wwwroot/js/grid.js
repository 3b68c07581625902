// The grid of latitude and longitude over the picture.

import { meetSphere, placeOf, pointAt, rayThrough, turn } from './geometry.js';
import { fixed, longitudeText } from './text.js';

const COLOUR = 'rgba(120, 200, 255, 0.55)';
const STEPS = [30, 15, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];

const between = (from, to, count) => Array.from({ length: count + 1 }, (_, i) => from + (to - from) * i / count);

const multiples = (step, from, to) => {
    const first = Math.ceil(from / step);
    return Array.from({ length: Math.max(0, Math.floor(to / step) - first + 1) }, (_, i) => (first + i) * step);
};

const nearest = (list, value) =>
    list.reduce((best, item) => (Math.abs(item - value) < Math.abs(best - value) ? item : best), list[0]);

export class Grid {
    #seen;

    /** @param overlay draws lines and labels; @param isHalved whether longitudes are east and west. */
    constructor(overlay, isHalved = false) {
        Object.assign(this, { overlay, isHalved });
        this.#seen = this.#placesSeen();
    }

    /** The places that the picture's border and middle show, of the sphere. */
    #placesSeen() {
        const { width, height } = this.overlay.lens;
        const places = [];
        for (let i = 0; i <= 12; i++) {
            for (let k = 0; k <= 12; k++) {
                const ray = rayThrough(this.overlay.camera, this.overlay.lens, [1 + (width - 1) * i / 12, 1 + (height - 1) * k / 12]);
                const point = meetSphere(this.overlay.camera.position, ray);
                if (point) {
                    places.push(placeOf(point));
                }
            }
        }
        return places;
    }

    /** Degrees between the lines of the grid: about six lines across what is seen. Null without Moon. */
    step() {
        const places = this.#seen;
        if (places.length === 0) {
            return null;
        }
        const latitudes = places.map(place => place.latitude);
        const span = Math.max(...latitudes) - Math.min(...latitudes);
        return STEPS.find(step => span / step >= 5) ?? STEPS.at(-1);
    }

    /** Parallels and meridians of the sphere, where the picture shows it. */
    draw() {
        const step = this.step();
        if (step === null) {
            return;
        }
        const { south, north, west, east, middle } = this.#extent(step);
        const isPolar = Math.max(-south, north) > 80;
        const parallels = multiples(step, south, north).filter(latitude => Math.abs(latitude) < 90);
        const meridians = multiples(isPolar ? Math.max(step, 10) : step, west, east === west + 360 ? east - 1e-9 : east);
        for (const latitude of parallels) {
            this.overlay.line(between(west, east, 720).map(longitude => pointAt(latitude, longitude)), COLOUR);
        }
        for (const longitude of meridians) {
            this.overlay.line(between(south, north, 360).map(latitude => pointAt(latitude, longitude)), COLOUR);
        }
        this.overlay.drawLimb(COLOUR);
        const decimals = Math.max(0, -Math.floor(Math.log10(step)));
        const [alongLatitude, alongLongitude] = [nearest(parallels, middle.latitude), nearest(meridians, middle.longitude)];
        for (const longitude of meridians.sort((a, b) => Math.abs(a - middle.longitude) - Math.abs(b - middle.longitude))) {
            this.#gridLabel(alongLatitude, longitude, longitudeText(turn(longitude), decimals, this.isHalved));
        }
        for (const latitude of parallels) {
            const letter = latitude < 0 ? ' S' : latitude > 0 ? ' N' : '';
            this.#gridLabel(latitude, alongLongitude, `${fixed(Math.abs(latitude), decimals)}°${letter}`);
        }
    }

    /** The part of the sphere that the grid covers, degrees; longitudes count on from the middle's. It reaches to the limb. */
    #extent(step) {
        const middle = this.#seen[Math.floor(this.#seen.length / 2)];
        const places = [...this.#seen, ...this.overlay.limbSeen().map(placeOf)];
        const latitudes = places.map(place => place.latitude);
        const [south, north] = step >= 15 ? [-90, 90]
            : [Math.max(Math.min(...latitudes) - step, -90), Math.min(Math.max(...latitudes) + step, 90)];
        const offsets = places.map(place => turn(place.longitude - middle.longitude + 180) - 180);
        const [west, east] = step >= 15 || Math.max(-south, north) > 80 ? [-180, 180]
            : [Math.min(...offsets) - step, Math.max(...offsets) + step];
        return { south, north, west: middle.longitude + west, east: middle.longitude + east, middle };
    }

    #gridLabel(latitude, longitude, text) {
        const place = latitude === undefined || longitude === undefined ? null : this.overlay.at(pointAt(latitude, longitude));
        if (place) {
            this.overlay.label(text, [place[0] + this.overlay.text / 4, place[1] - this.overlay.text * 0.7], '#bfe3ff');
        }
    }
}
