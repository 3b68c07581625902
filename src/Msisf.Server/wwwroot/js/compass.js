// North and the Sun as arrows with words, and the scale bar: for the middle of the picture.

import { cameraOf, combine, length, localAxes, normalize, placeOf, project, subtract, sunAt } from './geometry.js';
import { centreOf, pixelSize } from './models.js';
import { degrees, lengthText, roundBelow, windOf } from './text.js';

const $ = id => document.getElementById(id);
const WIDEST_CELL = 10; // px: wider cells show as facets; that of the command line's note
const SIDES = ['up', 'up right', 'right', 'down right', 'down', 'down left', 'left', 'up left'];

/** Direction in the picture in which a direction of space points from a point: radians from up, clockwise; null along the sight. */
function directionIn(view, size, point, direction) {
    const lens = { ...size, fov: view.fov };
    const camera = cameraOf(view);
    const step = length(subtract(point, camera.position)) * 1e-3;
    const [from, to] = [project(camera, lens, point), project(camera, lens, combine([point, 1], [direction, step]))];
    const [x, y] = from && to ? [to[0] - from[0], to[1] - from[1]] : [0, 0];
    return Math.hypot(x, y) < 1e-3 ? null : Math.atan2(x, -y);
}

const sideOf = angle => SIDES[(Math.round(angle / (Math.PI / 4)) + 8) % 8];

/** Shows the arrows of north and of the Sun along the ground. */
export function showCompass(view, size, sunPosition) {
    const centre = centreOf(view, size);
    $('compass').hidden = !centre;
    if (!centre) {
        return null;
    }
    const { latitude, longitude } = placeOf(centre);
    const { north, up } = localAxes(latitude, longitude);
    const sun = sunPosition && sunAt(centre, sunPosition);
    const toSun = sunPosition && normalize(subtract(sunPosition, centre));
    const level = toSun && combine([toSun, 1], [up, -(toSun[0] * up[0] + toSun[1] * up[1] + toSun[2] * up[2])]);
    const arrows = [['N', '#e8ecf3', directionIn(view, size, centre, north)]];
    if (level && length(level) > 1e-6) {
        arrows.push(['Sun', sun.elevation < 0 ? '#9db4ff' : '#ffc46b', directionIn(view, size, centre, normalize(level))]);
    }
    draw($('compass-arrows'), arrows.filter(([, , angle]) => angle !== null));
    const [, , northAngle] = arrows[0];
    const from = sun?.azimuth === null ? 'overhead' : sun && `from ${windOf(sun.azimuth)}`;
    const words = [
        northAngle === null ? '' : `North ${sideOf(northAngle)}`,
        sun ? `Sun ${from}, ${sun.elevation < 0 ? 'set' : degrees(sun.elevation, 0)}` : '',
    ].filter(Boolean);
    $('compass-words').innerText = words.join('\n');
    return sun;
}

function draw(canvas, arrows) {
    const ratio = window.devicePixelRatio || 1;
    const side = Math.round(canvas.clientWidth * ratio);
    if (side === 0) {
        return; // hidden
    }
    [canvas.width, canvas.height] = [side, side];
    const pen = canvas.getContext('2d');
    const text = 0.875 * parseFloat(getComputedStyle(document.documentElement).fontSize) * ratio;
    pen.translate(side / 2, side / 2);
    pen.font = `600 ${text}px system-ui, sans-serif`;
    [pen.textAlign, pen.textBaseline, pen.lineCap] = ['center', 'middle', 'round'];
    const reach = side / 2 - text * 1.7;
    pen.fillStyle = 'rgba(7, 9, 13, 0.55)';
    pen.beginPath();
    pen.arc(0, 0, reach + text * 0.2, 0, 2 * Math.PI);
    pen.fill();
    for (const [name, colour, angle] of arrows) {
        const [x, y] = [Math.sin(angle), -Math.cos(angle)];
        pen.strokeStyle = pen.fillStyle = colour;
        pen.lineWidth = 2 * ratio;
        pen.beginPath();
        pen.moveTo(0, 0);
        pen.lineTo(x * reach * 0.75, y * reach * 0.75);
        pen.stroke();
        pen.beginPath();
        pen.moveTo(x * reach, y * reach);
        for (const aside of [1, -1]) {
            pen.lineTo(x * reach * 0.66 + aside * y * reach * 0.18, y * reach * 0.66 - aside * x * reach * 0.18);
        }
        pen.fill();
        pen.lineWidth = text / 4;
        pen.strokeStyle = '#000';
        const aside = (side - pen.measureText(name).width) / 2 - ratio;
        const room = [Math.min(Math.max(x * (reach + text * 1.2), -aside), aside), y * (reach + text * 0.8)];
        pen.strokeText(name, ...room);
        pen.fillText(name, ...room);
    }
}

/** Shows how long a round length is in the middle of the picture, across the line of sight. */
export function showScaleBar(view, size, pagePixels) {
    const metres = pixelSize(view, size) * size.width / Math.max(1, pagePixels); // a pixel of the page
    const long = roundBelow(metres * Math.min(180, pagePixels / 4));
    $('scale-bar').querySelector('i').style.width = `${long / metres}px`;
    $('scale-length').textContent = lengthText(long).replace(/\.0+ /, ' ');
}

/** Says which model is drawn, and how large its cells are; of cells that show as facets also what can be done, as the command line does. */
export function sayModel(view, size, model, { refine, seed }) {
    const { name, metres_per_pixel: cell } = model ?? {};
    const width = cell / pixelSize(view, size);
    const pixels = Number(width.toPrecision(2)); // 240, not 2.4e+2
    $('model-said').textContent = model ? `${name}: cells of ${lengthText(cell)}, ${pixels} px` : '';
    $('coarse').hidden = !(width > WIDEST_CELL);
    $('coarse-said').textContent = refine ? `Terrain finer than ${name} is invented (seed ${seed}); it is not real.`
        : 'A finer model would show more.';
    $('refine-here').checked = refine;
}
