// What is drawn over the picture of things on the ground: names, craters, landmarks.

import {
    circleAround, combine, dot, focalLength, length, normalize, pointAt, scale, subtract, sunAt, REFERENCE_RADIUS,
} from './geometry.js';
import { fixed } from './text.js';

const COLOURS = { crater: '#b6f09c', hidden: '#9aa0a6', landmark: '#7cd5ff', name: '#f2f5fa', nightName: '#7f8aa0' };

/** Names cover at most this part of the Moon in the picture: more hide it, and nobody finds one among them. */
const NAMED_PART = 0.05;

/** Names of features in the middle of them, the largest first, where there is room; at the limb those that are not too narrow. */
export function drawNames(overlay, features, sunPosition, most = 40) {
    const focal = focalLength(overlay.lens.width, overlay.lens.fov) * overlay.unit;
    const nearest = overlay.nearest;
    let [drawn, room] = [0, NAMED_PART * overlay.moonArea];
    for (const { name, latitude, longitude, diameter, weight } of features) {
        if (4 * weight * focal / nearest < 2.2 * overlay.text) {
            return;
        }
        const centre = pointAt(latitude, longitude);
        const place = overlay.at(centre);
        const sight = subtract(overlay.camera.position, centre);
        const size = diameter * focal / length(sight);
        const narrow = place ? size * dot(normalize(sight), normalize(centre)) : 0;
        const isFit = place && narrow > 2.2 * overlay.text && size < 2.5 * overlay.canvas.width;
        const isNight = isFit && sunPosition && sunAt(centre, sunPosition).elevation < 0;
        const box = isFit && overlay.label(name, place, isNight ? COLOURS.nightName : COLOURS.name, 'center', overlay.text);
        if (box) {
            drawn += 1;
            room -= (box[2] - box[0]) * (box[3] - box[1]);
        }
        if (drawn === most || room < 0) {
            return;
        }
    }
}

/** Circles and names of the largest craters that are in the picture. */
export function drawCraters(overlay, craters, most = 60) {
    const focal = focalLength(overlay.lens.width, overlay.lens.fov) * overlay.unit;
    const nearest = overlay.nearest;
    let drawn = 0;
    for (const { name, latitude, longitude, diameter } of craters) {
        if (diameter * focal / nearest < 1.5 * overlay.text) {
            return; // the others are smaller
        }
        const centre = pointAt(latitude, longitude);
        const place = overlay.at(centre);
        const distance = Math.hypot(...combine([centre, 1], [overlay.camera.position, -1]));
        const size = diameter * focal / distance;
        const isInside = place && place[0] > 0 && place[1] > 0 && place[0] < overlay.canvas.width && place[1] < overlay.canvas.height;
        if (!isInside || size < 1.5 * overlay.text || size > 1.5 * overlay.canvas.width) {
            continue;
        }
        const angle = diameter / 2 / REFERENCE_RADIUS * 180 / Math.PI;
        if (overlay.label(name ?? `${fixed(diameter / 1000, diameter < 1e4 ? 1 : 0)} km`, place, COLOURS.crater, 'center')) {
            overlay.line(circleAround(centre, angle, 48).map(point => scale(point, REFERENCE_RADIUS)), COLOURS.crater);
            drawn += 1;
        }
        if (drawn === most) {
            return;
        }
    }
}

/** The rims of craters as the frame's own truth has them: ellipses in pixels; grey where most is hidden. */
export function drawRims(overlay, craters) {
    for (const { id, name, h, v, semiMajor, semiMinor, turn, hidden } of craters) {
        const [x, y] = overlay.of([h, v]);
        const colour = hidden > 0.5 ? COLOURS.hidden : COLOURS.crater;
        const path = new Path2D();
        path.ellipse(x, y, semiMajor * overlay.unit, semiMinor * overlay.unit, turn * Math.PI / 180, 0, 2 * Math.PI);
        overlay.context.strokeStyle = colour;
        overlay.context.stroke(path);
        if (semiMajor * overlay.unit > 1.5 * overlay.text) {
            overlay.label(name ?? id, [x, y], colour, 'center');
        }
    }
}

/** Crosses where landmarks are, by the frame's own truth; grey where they are hidden. */
export function drawLandmarks(overlay, landmarks) {
    for (const { id, name, h, v, visible } of landmarks) {
        const [x, y] = overlay.of([h, v]);
        const colour = visible === 'yes' ? COLOURS.landmark : COLOURS.hidden;
        const path = new Path2D();
        const arm = overlay.text / 2;
        path.moveTo(x - arm, y);
        path.lineTo(x + arm, y);
        path.moveTo(x, y - arm);
        path.lineTo(x, y + arm);
        overlay.strokeTwice(path, colour);
        overlay.label(name ?? id, [x + overlay.text * 0.8, y - overlay.text * 0.6], colour);
    }
}
