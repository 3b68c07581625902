// What is shown before the first picture is there: the smooth sphere under a Sun that is about right.

import { cameraOf, dot, meetSphere, normalize, rayThrough } from './geometry.js';

const LONGEST = 240; // px

/** Direction to the Sun at an MJD, to some degrees: the mean Moon turns once in 29.53 days under it. */
export function aboutSun(mjd) {
    const angle = -2 * Math.PI * (mjd - 51550.26) / 29.530589 + Math.PI; // new Moon of 2000-01-06: the far side is lit
    return [Math.cos(angle), Math.sin(angle), 0];
}

/** Grey levels of the sphere by Lambert's law. */
export function sphereImage(view, size) {
    const factor = Math.min(1, LONGEST / Math.max(size.width, size.height));
    const [width, height] = [Math.max(1, Math.round(size.width * factor)), Math.max(1, Math.round(size.height * factor))];
    const [camera, sun, values] = [cameraOf(view), aboutSun(view.mjd), new Uint8Array(width * height)];
    for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
            const point = meetSphere(camera.position, rayThrough(camera, { width, height, fov: view.fov }, [x + 1, y + 1]));
            values[y * width + x] = point ? 26 + 90 * Math.sqrt(Math.max(0, dot(normalize(point), sun))) : 4;
        }
    }
    return { width, height, values };
}
