// Wires the page: the state to the picture, the picture to the numbers.

import { Address } from './address.js';
import { Compare } from './compare.js';
import { copy } from './copy.js';
import { Frames } from './frames.js';
import { LayerView } from './layer-view.js';
import { Marks } from './marks.js';
import { Navigation } from './navigation.js';
import { Panel } from './panel.js';
import { Picture } from './picture.js';
import { Reader, Readings } from './readings.js';
import { getJson, readPixels } from './server.js';
import { Stage } from './stage.js';
import { State } from './state.js';
import { Sun } from './sun.js';
import { TakeAway } from './takeaway.js';
import { lengthText } from './text.js';

const $ = id => document.getElementById(id);

const state = new State();
let offers = { models: [] };
let crosshair = null;
let groundHeight = 0;

/** Words about the address, which stay until something is changed; others go when the next picture is there. */
let aboutAddress = null;

const notice = words => {
    const text = words ?? aboutAddress;
    $('notice').textContent = text ?? '';
    $('notice').hidden = !text;
};

const stage = new Stage($('stage'), $('picture'), (width, height) => state.fitTo(width, height));
const readings = new Readings($('readings'), $('between'), () => marks.draw());
const sun = new Sun(() => {
    sun.showOver(state);
    marks.draw();
});
const picture = new Picture(stage, state, () => navigation.isMoving, {
    onShown: () => marks.draw(),
    onRest: atRest,
    onStatus: words => $('status').textContent = words,
    onNotice: notice,
});
const layer = new LayerView(stage, notice);
const marks = new Marks(
    stage,
    () => ({ shown: picture.shown, isAtRest: picture.isAtRest, sunPosition: sun.position, readings, crosshair }),
    notice);
const panel = new Panel(state);
const address = new Address(state, readings);
const ask = async pixel => (await readPixels(picture.shown.frame, [pixel])).at(0);
const reader = new Reader(
    ask,
    reading => {
        readings.set('here', reading);
        if (crosshair) {
            $('spoken').textContent = readings.sentence;
        }
    });
const navigation = new Navigation(stage, state, {
    ground: () => groundHeight,
    onPoint: pixel => !crosshair && point(pixel),
    onCrosshair: moveCrosshair,
    onPin: pin,
});
const compare = new Compare(stage, notice);
const frames = new Frames(state, picture, () => offers, notice);
new TakeAway(
    () => ({ ...(picture.isStored ? picture.shown.frame : state.frame()), samples: state.picture.samples }), () => offers.models, notice);

/** Reads a pixel of the picture, as soon as it is at rest. */
let pointed = null;
function point(pixel) {
    pointed = pixel;
    if (picture.shown?.frame && picture.isAtRest) {
        reader.read(pixel);
    }
}

function atRest(frame) {
    address.write();
    layer.show(frame);
    marks.know(frame);
    point(crosshair ?? pointed);
    findGround();
}

/** How high the terrain below the camera is: one pixel that looks straight down. */
async function findGround() {
    const { view } = state;
    const down = new State();
    down.picture = { ...state.picture };
    down.look({ ...view, tilt: 0, roll: 0, fov: 1 });
    const [reading] = await readPixels(down.frame({ width: 1, height: 1 }), [[1, 1]]).catch(() => [null]);
    if (reading && view === state.view) {
        groundHeight = reading.height;
        $('over-terrain').textContent = lengthText(view.altitude - groundHeight);
    }
}

/** Pins what is read; a click may come before its reading does. */
async function pin() {
    const pixel = crosshair ?? pointed;
    if (!pixel || !picture.shown?.frame || !picture.isAtRest) {
        return;
    }
    const here = readings.get('here');
    const isRead = here?.pixel.every((number, axis) => number === pixel[axis]);
    const reading = isRead ? here : await ask(pixel).catch(() => null);
    readings.pin(reading && { ...reading, pixel });
    address.write();
    $('spoken').textContent = reading ? $('between').textContent : 'There is no Moon to pin here.';
}

function unpin() {
    readings.unpin();
    address.write();
}

function setCrosshair(pixel) {
    crosshair = pixel;
    $('crosshair').setAttribute('aria-pressed', pixel !== null);
    point(pixel);
    marks.draw();
}

function toggleCrosshair() {
    const { width, height } = picture.shown?.size ?? state.size;
    setCrosshair(crosshair ? null : [Math.ceil(width / 2), Math.ceil(height / 2)]);
}

function moveCrosshair([dx, dy]) {
    if (!crosshair) {
        return false;
    }
    const { width, height } = picture.shown.size;
    setCrosshair([Math.min(Math.max(crosshair[0] + dx, 1), width), Math.min(Math.max(crosshair[1] + dy, 1), height)]);
    return true;
}

const KEYS = {
    c: toggleCrosshair,
    p: pin,
    u: unpin,
    n: () => $('north-up').click(),
    0: () => $('look-down').click(),
    l: () => layer.next(),
    g: () => marks.toggle('show-grid'),
    t: () => marks.toggle('show-terminator'),
    b: () => compare.toggleBlink(),
    ',': () => panel.stepTime(-1 / 24),
    '.': () => panel.stepTime(1 / 24),
    '<': () => panel.stepTime(-1),
    '>': () => panel.stepTime(1),
    '?': () => $('help').showModal(),
    PageUp: () => frames.step(-1),
    PageDown: () => frames.step(1),
    ' ': () => frames.togglePlay(),
    Escape: () => crosshair && toggleCrosshair(),
};

document.addEventListener('keydown', event => {
    const isBusy = event.ctrlKey || event.metaKey || event.altKey || $('help').open;
    const action = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    const isHere = event.target === stage.stage || (event.key === '?' && !event.target.closest('input, select, textarea'));
    if (action && isHere && !isBusy) {
        event.preventDefault();
        action();
    }
});

function show(isStored) {
    aboutAddress = null;
    layer.hide();
    readings.set('here', null);
    if (!isStored) {
        picture.draw();
    }
    panel.show();
    sun.at(state.view.mjd);
    sun.showOver(state);
    frames.onView();
}

stage.onPlaced = () => marks.draw();
$('crosshair').addEventListener('click', toggleCrosshair);
$('pin').addEventListener('click', pin);
$('unpin').addEventListener('click', unpin);
$('readings-copy').addEventListener('click', () => copy(readings.json));
$('help-open').addEventListener('click', () => $('help').showModal());
window.addEventListener('hashchange', () => tellAboutAddress(readAddress()));

function readAddress() {
    const words = address.read(offers.models);
    panel.anchorTime();
    return words;
}

function tellAboutAddress(words) {
    aboutAddress = words;
    notice(null);
}

async function start() {
    offers = await getJson('/v1/models');
    Panel.offer($('model'), Panel.modelChoices(offers));
    Panel.offer($('reflectance'), (offers.reflectances ?? []).map(item => ({ value: item.name ?? item })));
    for (const list of ['catalogue', 'landmarks']) {
        Panel.offer($(list), (offers.catalogues ?? []).map(({ name }) => ({ value: name })));
    }
    await frames.offer();
    const words = readAddress();
    state.onChange(show);
    if (location.hash.length < 2) {
        panel.wholeMoon();
    } else {
        state.draw({});
    }
    tellAboutAddress(words);
}

start().catch(error => notice(error.message));
