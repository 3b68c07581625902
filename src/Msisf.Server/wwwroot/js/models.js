// Which elevation model is drawn: pure functions.

import { cameraOf, length, limbAngle, meetSphere, rayThrough, subtract, REFERENCE_RADIUS } from './geometry.js';

/** The coarsest model is taken whose cells are below so many pixels. */
const CELL_PIXELS = 2;

/** Where the middle of the picture meets the sphere; null beside the Moon. */
export function centreOf(view, size) {
    const camera = cameraOf(view);
    return meetSphere(camera.position, rayThrough(camera, { ...size, fov: view.fov }, [(size.width + 1) / 2, (size.height + 1) / 2]));
}

/** m: what a pixel in the middle of the picture covers across the line of sight; beside the Moon a pixel at the limb. */
export function pixelSize(view, size) {
    const camera = cameraOf(view);
    const centre = centreOf(view, size);
    const distance = centre ? length(subtract(centre, camera.position))
        : limbAngle(camera) === null ? 1
        : Math.sqrt(length(camera.position) ** 2 - REFERENCE_RADIUS ** 2);
    return distance * 2 * Math.tan(view.fov * Math.PI / 360) / size.width;
}

/** The model of the whole Moon for pixels of a size in m; the finest where all are too coarse. Undefined without any. */
export function modelFor(models, metres) {
    const whole = models.filter(model => model.whole_moon).sort((a, b) => b.metres_per_pixel - a.metres_per_pixel);
    return whole.find(model => model.metres_per_pixel < CELL_PIXELS * metres) ?? whole.at(-1);
}
