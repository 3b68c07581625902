// Vectors, the camera and the sphere: pure functions. Lengths in m, axes MOON_ME, angles in degrees.
// docs/camera-model.md has the conventions: the camera looks along its -x, y is to the right, z up.

export const REFERENCE_RADIUS = 1737400;

const DEGREE = Math.PI / 180;

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = a => Math.hypot(a[0], a[1], a[2]);
export const scale = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const normalize = a => scale(a, 1 / length(a));

/** The sum of vectors times factors: combine([a, 2], [b, -1]) is 2a - b. */
export const combine = (...terms) => terms.reduce(
    (sum, [vector, factor]) => [sum[0] + vector[0] * factor, sum[1] + vector[1] * factor, sum[2] + vector[2] * factor], [0, 0, 0]);

/** The angle between two vectors, exact for small ones too (Kahan, "Mindless", section 12). */
export function angleBetween(a, b) {
    const [u, v] = [scale(a, length(b)), scale(b, length(a))];
    return 2 * Math.atan2(length(subtract(u, v)), length(combine([u, 1], [v, 1]))) / DEGREE;
}

/** An angle as one of [0, 360). */
export const turn = angle => {
    const rest = angle % 360;
    return rest < 0 ? (rest + 360) % 360 : rest;
};

/** The point at a place, height in m over the reference radius. */
export function pointAt(latitude, longitude, height = 0) {
    const [phi, lambda, radius] = [latitude * DEGREE, longitude * DEGREE, REFERENCE_RADIUS + height];
    return [radius * Math.cos(phi) * Math.cos(lambda), radius * Math.cos(phi) * Math.sin(lambda), radius * Math.sin(phi)];
}

/** The place of a point. */
export function placeOf(point) {
    const equator = Math.hypot(point[0], point[1]);
    return {
        latitude: Math.atan2(point[2], equator) / DEGREE,
        longitude: equator === 0 ? 0 : turn(Math.atan2(point[1], point[0]) / DEGREE),
        height: length(point) - REFERENCE_RADIUS,
    };
}

/** East, north and up at a place; at a pole those of the meridian given. */
export function localAxes(latitude, longitude) {
    const [phi, lambda] = [latitude * DEGREE, longitude * DEGREE];
    return {
        east: [-Math.sin(lambda), Math.cos(lambda), 0],
        north: [-Math.sin(phi) * Math.cos(lambda), -Math.sin(phi) * Math.sin(lambda), Math.cos(phi)],
        up: [Math.cos(phi) * Math.cos(lambda), Math.cos(phi) * Math.sin(lambda), Math.sin(phi)],
    };
}

/** The quaternion [x, y, z, scalar] of the rotation whose matrix has these columns. */
export function quaternionOf(x, y, z) {
    const [a, b, c] = [x[0], y[1], z[2]];
    const fourSquares = [1 + a - b - c, 1 - a + b - c, 1 - a - b + c, 1 + a + b + c];
    const largest = fourSquares.indexOf(Math.max(...fourSquares));
    const sums = [x[1] + y[0], x[2] + z[0], y[2] + z[1]];
    const differences = [y[2] - z[1], z[0] - x[2], x[1] - y[0]];
    const quaternion = [
        [fourSquares[0], sums[0], sums[1], differences[0]],
        [sums[0], fourSquares[1], sums[2], differences[1]],
        [sums[1], sums[2], fourSquares[2], differences[2]],
        [differences[0], differences[1], differences[2], fourSquares[3]],
    ][largest];
    const sign = quaternion[3] < 0 ? -1 : 1;
    return quaternion.map(number => sign * number / Math.hypot(...quaternion));
}

/** A vector turned by a quaternion: q v q*. */
export function rotate([x, y, z, w], vector) {
    const axis = [x, y, z];
    const once = cross(axis, vector);
    return combine([vector, 1], [once, 2 * w], [cross(axis, once), 2]);
}

/**
 * The camera of a view: position, and the directions forward, right and up of its image. The heading is the direction
 * that is up in the image of a camera that looks straight down; the tilt turns it from there up towards the horizon, and the
 * roll turns the camera about its line of sight, clockwise as seen from behind it.
 */
export function cameraOf({ latitude, longitude, altitude, heading, tilt, roll }) {
    const { east, north, up } = localAxes(latitude, longitude);
    const [h, t, r] = [heading * DEGREE, tilt * DEGREE, roll * DEGREE];
    const ahead = combine([north, Math.cos(h)], [east, Math.sin(h)]);
    const level = combine([east, Math.cos(h)], [north, -Math.sin(h)]);
    const forward = combine([up, -Math.cos(t)], [ahead, Math.sin(t)]);
    const raised = combine([up, Math.sin(t)], [ahead, Math.cos(t)]);
    return {
        position: pointAt(latitude, longitude, altitude),
        forward,
        right: combine([level, Math.cos(r)], [raised, -Math.sin(r)]),
        up: combine([raised, Math.cos(r)], [level, Math.sin(r)]),
    };
}

/** The eight numbers of a state: MJD, position, quaternion. */
export function stateOf(view) {
    const { position, forward, right, up } = cameraOf(view);
    return [view.mjd, ...position, ...quaternionOf(scale(forward, -1), right, up)];
}

/** The view of a state; the field of view is none of its numbers. */
export function viewOf([mjd, x, y, z, ...quaternion]) {
    const { latitude, longitude, height } = placeOf([x, y, z]);
    const { east, north, up } = localAxes(latitude, longitude);
    const forward = rotate(quaternion, [-1, 0, 0]);
    const imageUp = rotate(quaternion, [0, 0, 1]);
    const aside = Math.hypot(dot(forward, east), dot(forward, north));
    const tilt = Math.atan2(aside, -dot(forward, up)) / DEGREE;
    // Looking straight down or up, forward has no azimuth: then the image's up has the heading.
    const ahead = aside > 1e-9 ? forward : scale(imageUp, tilt < 90 ? 1 : -1);
    const heading = turn(Math.atan2(dot(ahead, east), dot(ahead, north)) / DEGREE);
    const level = cameraOf({ latitude, longitude, altitude: height, heading, tilt, roll: 0 });
    const roll = Math.atan2(dot(imageUp, level.right), dot(imageUp, level.up)) / DEGREE;
    return { mjd, latitude, longitude, altitude: height, heading, tilt, roll };
}

/** The focal length in px of an image with a horizontal field of view. */
export const focalLength = (width, fov) => width / (2 * Math.tan(fov * DEGREE / 2));

/** The direction through the point x, y of an image; the middle of its first pixel is 1, 1. */
export function rayThrough(camera, { width, height, fov }, [x, y]) {
    const f = focalLength(width, fov);
    return normalize(combine([camera.forward, f], [camera.right, x - (width + 1) / 2], [camera.up, (height + 1) / 2 - y]));
}

/** Where a point of space is in the image, or null if it is not in front of the camera. */
export function project(camera, { width, height, fov }, point) {
    const offset = subtract(point, camera.position);
    const depth = dot(offset, camera.forward);
    if (!(depth > 0)) {
        return null;
    }
    const f = focalLength(width, fov) / depth;
    return [(width + 1) / 2 + f * dot(offset, camera.right), (height + 1) / 2 - f * dot(offset, camera.up)];
}

/** Where a ray first meets the reference sphere, or null. */
export function meetSphere(origin, direction, radius = REFERENCE_RADIUS) {
    const nearest = -dot(origin, direction);
    const closest = length(combine([origin, 1], [direction, nearest]));
    if (closest > radius || nearest < 0 || length(origin) < radius) {
        return null;
    }
    const halfChord = Math.sqrt((radius - closest) * (radius + closest));
    return combine([origin, 1], [direction, nearest - halfChord]);
}

/** Whether the sphere through a point lets the camera see it. */
export const isOnNearSide = (camera, point) => dot(subtract(camera.position, point), point) > 0;

/** The angle from the point below the camera to the sphere's limb, as seen from the Moon's centre; null from within the sphere. */
export function limbAngle({ position }) {
    const distance = length(position);
    const [least, most] = [distance - REFERENCE_RADIUS, distance + REFERENCE_RADIUS];
    return least > 0 ? Math.atan2(Math.sqrt(least * most), REFERENCE_RADIUS) / DEGREE : null;
}

/**
 * The parts of a line over the sphere that the camera sees; where the line goes over the limb, a part ends there.
 * @param points so close to each other that between them the line is straight.
 */
export function seenParts({ position }, points) {
    const facing = points.map(point => dot(subtract(position, point), point)); // above 0 on the near side, 0 on the limb
    const parts = [];
    let part = null;
    for (const [index, point] of points.entries()) {
        const isSeen = facing[index] > 0;
        if (index > 0 && isSeen !== facing[index - 1] > 0) {
            const way = facing[index - 1] / (facing[index - 1] - facing[index]);
            const limb = combine([points[index - 1], 1 - way], [point, way]);
            const onLimb = scale(limb, length(point) / length(limb));
            if (isSeen) {
                parts.push(part = [onLimb]);
            } else {
                part.push(onLimb);
            }
        } else if (isSeen && index === 0) {
            parts.push(part = []);
        }
        if (isSeen) {
            part.push(point);
        }
    }
    return parts;
}

/** The Sun over the horizontal plane of a point: elevation, and azimuth clockwise from north (null in the zenith). */
export function sunAt(point, sunPosition) {
    const { latitude, longitude } = placeOf(point);
    const { east, north, up } = localAxes(latitude, longitude);
    const direction = normalize(subtract(sunPosition, point));
    const [x, y] = [dot(direction, east), dot(direction, north)];
    const aside = Math.hypot(x, y);
    return {
        elevation: Math.atan2(dot(direction, up), aside) / DEGREE,
        azimuth: aside < 1e-12 ? null : turn(Math.atan2(x, y) / DEGREE),
    };
}

/** The great-circle distance on the reference sphere between the places below two points, m. */
export const groundDistance = (a, b) => angleBetween(a, b) * DEGREE * REFERENCE_RADIUS;

/**
 * The area on the reference sphere that great circles between points enclose, the last joined to the first, m²: the sum over triangles
 * (Van Oosterom and Strackee, 1983). Where the line crosses itself, what it goes around the other way counts as negative.
 */
export function enclosedArea(points) {
    const [first, ...others] = points.map(normalize);
    const angles = others.slice(1).map((c, index) => {
        const b = others[index];
        return 2 * Math.atan2(dot(first, cross(b, c)), 1 + dot(first, b) + dot(b, c) + dot(c, first));
    });
    return Math.abs(angles.reduce((sum, angle) => sum + angle, 0)) * REFERENCE_RADIUS ** 2;
}

/**
 * The view after the camera has gone along great circles: so many degrees ahead (where the image's up points when it
 * looks down) and to the right. Across a pole the way goes straight on.
 */
export function travelled(view, ahead, right) {
    const angle = Math.hypot(ahead, right) * DEGREE;
    if (angle === 0) {
        return view;
    }
    const { east, north, up } = localAxes(view.latitude, view.longitude);
    const course = view.heading * DEGREE + Math.atan2(right, ahead);
    const start = combine([north, Math.cos(course)], [east, Math.sin(course)]);
    const place = placeOf(scale(combine([up, Math.cos(angle)], [start, Math.sin(angle)]), REFERENCE_RADIUS));
    const end = combine([start, Math.cos(angle)], [up, -Math.sin(angle)]);
    const axes = localAxes(place.latitude, place.longitude);
    const arrived = Math.atan2(dot(end, axes.east), dot(end, axes.north));
    return {
        ...view,
        latitude: place.latitude,
        longitude: place.longitude,
        heading: turn(view.heading + (arrived - course) / DEGREE),
    };
}

/** As travelled, with the compass held: what was up in the image stays so. Near the poles that has no meaning. */
export function shifted(view, ahead, right) {
    const moved = travelled(view, ahead, right);
    return Math.abs(moved.latitude) > 80 || Math.abs(view.latitude) > 80 ? moved : { ...moved, heading: view.heading };
}

/** Points of the circle around a direction, each as a vector of length 1. */
export function circleAround(direction, radiusDegrees, count) {
    const axis = normalize(direction);
    const other = Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
    const first = normalize(cross(axis, other));
    const second = cross(axis, first);
    const [along, aside] = [Math.cos(radiusDegrees * DEGREE), Math.sin(radiusDegrees * DEGREE)];
    return Array.from({ length: count + 1 }, (_, index) => {
        const angle = 2 * Math.PI * index / count;
        return combine([axis, along], [first, aside * Math.cos(angle)], [second, aside * Math.sin(angle)]);
    });
}
