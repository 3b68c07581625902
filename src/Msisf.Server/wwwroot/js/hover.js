// The reading that follows the pointer: place, height, light, shadow, pixel; five lines.

import { pointAt, placeOf, subtract, combine, normalize, sunAt } from './geometry.js';
import { degrees, fixed, lengthText, placeText, windOf } from './text.js';

const $ = id => document.getElementById(id);

/** What stands before the Sun, in words. */
function shadeOf(reading, sun, toSun, isHalved) {
    if (reading.shaded_at === null) {
        return 'In shadow';
    }
    if (reading.shaded_at === 0) {
        return 'In shadow: the slope faces away';
    }
    const from = placeOf(combine([reading.position, 1], [toSun, reading.shaded_at]));
    return `In the shadow of ground ${lengthText(reading.shaded_at)} ${windOf(sun.azimuth ?? 0)}, ${placeText(from, isHalved, 2)}`;
}

/** The five lines of a reading. */
export function hoverLines(reading, sunPosition, isHalved) {
    const { latitude, longitude, height } = reading;
    const point = reading.position ?? pointAt(latitude, longitude, height);
    const sun = sunPosition && sunAt(point, sunPosition);
    const high = sun && (sun.elevation < 0 ? `${degrees(-sun.elevation, 1)} below the horizon` : `${degrees(sun.elevation, 1)} high`);
    return [
        placeText(reading, isHalved, 4),
        `Height ${fixed(height, 0)} m${reading.facet.invented ? ', INVENTED' : ''}, slope ${degrees(reading.slope, 1)}`,
        !sun ? 'Sun –' : `Sun ${high}, ${sun.azimuth === null ? 'overhead' : `azimuth ${degrees(sun.azimuth, 1)} ${windOf(sun.azimuth)}`}`,
        reading.lit === 'lit' ? `Lit, incidence ${degrees(reading.incidence, 1)}`
            : reading.lit === 'penumbra' ? `Penumbra: ${fixed(100 * reading.lit_fraction, 0)} % of the Sun`
            : reading.lit === 'night' ? 'Night'
            : shadeOf(reading, sun ?? {}, sunPosition ? normalize(subtract(sunPosition, point)) : [0, 0, 0], isHalved),
        `Pixel ${lengthText(reading.pixel_scale)}, ${lengthText(reading.distance)} away`,
    ];
}

const GAP = 18; // px of the page beside the pointer

export class Hover {
    /** @param stage knows where pixels are; @param sunPosition and isHalved answer what the lines need. */
    constructor(stage, sunPosition, isHalved) {
        Object.assign(this, { stage, sunPosition, isHalved, card: $('hover') });
    }

    /** Shows a reading beside its pixel; null hides it. */
    show(reading) {
        this.card.hidden = !reading;
        if (!reading) {
            return;
        }
        const lines = hoverLines(reading, this.sunPosition(), this.isHalved());
        for (const [index, line] of lines.entries()) {
            this.card.children[index].textContent = line;
        }
        $('hover-light').className = reading.lit;
        this.#place(reading.pixel);
    }

    /** To the right below the pointer, or on its other sides where there is no room. */
    #place(pixel) {
        const [x, y] = this.stage.placeOf(pixel);
        const { clientWidth: width, clientHeight: height } = this.stage.stage;
        const { offsetWidth, offsetHeight } = this.card;
        const left = x + GAP + offsetWidth > width - 8 ? Math.max(8, x - GAP - offsetWidth) : x + GAP;
        const top = y + GAP + offsetHeight > height - 8 ? Math.max(8, y - GAP - offsetHeight) : y + GAP;
        this.card.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
    }
}
