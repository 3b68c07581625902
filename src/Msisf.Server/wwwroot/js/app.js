// Wires the page: the state to the picture, the picture to the numbers.

import { Address } from './address.js';
import { Compare } from './compare.js';
import { sayModel, showCompass, showScaleBar } from './compass.js';
import { Connection } from './connection.js';
import { Contours } from './contours.js';
import { copy } from './copy.js';
import { Drawers } from './drawers.js';
import { Frames } from './frames.js';
import { Hover } from './hover.js';
import { LayerView } from './layer-view.js';
import { NextLight } from './light.js';
import { Marks } from './marks.js';
import { Names } from './names.js';
import { Navigation } from './navigation.js';
import { Overview } from './overview.js';
import { Panel } from './panel.js';
import { Picture } from './picture.js';
import { Pins } from './pins.js';
import { Pointing } from './pointing.js';
import { Readings } from './readings.js';
import { getJson } from './server.js';
import { sphereImage } from './sphere.js';
import { Stage } from './stage.js';
import { State } from './state.js';
import { Sun } from './sun.js';
import { TakeAway } from './takeaway.js';
import { TimeBar } from './timebar.js';
import { Undo } from './undo.js';

const $ = id => document.getElementById(id);

const state = new State();
let offers = { models: [] };

/** Words about the address, which stay until something is changed; others go when the next picture is there. */
let aboutAddress = null;

const notice = words => {
    const text = words ?? aboutAddress;
    $('notice').textContent = text ?? '';
    $('notice').hidden = !text;
};

const isHalved = () => $('longitudes').value === '180';
const stage = new Stage($('stage'), $('picture'), (width, height) => state.fitTo(width, height));
const connection = new Connection(notice, () => {
    notice(null);
    start();
});
const readings = new Readings($('readings'), $('between'), () => $('path').checked, () => {
    marks.draw();
    pins.show();
});
const sun = new Sun(() => {
    overlook();
    marks.draw();
}, (words, known) => {
    timeBar.stop();
    state.look({ mjd: known ?? State.FIRST_TIME });
    timeBar.anchor();
    tellAboutAddress(words);
});
const picture = new Picture(stage, state, () => navigation.isMoving, {
    onShown: () => marks.draw(),
    onRest: atRest,
    onStatus: words => $('status').textContent = words,
    onNotice: notice,
    onLost: () => connection.lose(),
    onWork: isWorking => $('progress').hidden = !isWorking,
});
const layer = new LayerView(stage, notice);
const contours = new Contours(() => marks.draw(), notice);
const names = new Names(state, () => marks.draw(), notice, isHalved);
const frames = new Frames(state, picture, () => offers, notice);
const hover = new Hover(stage, () => sun.position, isHalved);
const pointing = new Pointing(stage, picture, readings, reading => {
    hover.show(reading);
    marks.draw();
}, () => address.write());
const marks = new Marks(
    stage,
    () => ({
        shown: picture.shown, isAtRest: picture.isAtRest, sunPosition: sun.position, readings, crosshair: pointing.crosshair,
        names: names.byWeight, states: frames.states, contours,
    }),
    points => overview.avoid(points), notice);
const panel = new Panel(state);
const timeBar = new TimeBar(state);
const address = new Address(state, readings);
const navigation = new Navigation(stage, state, {
    ground: () => pointing.groundHeight,
    onPoint: pixel => !pointing.crosshair && pointing.point(pixel),
    onCrosshair: way => pointing.moveCrosshair(way),
    onPin: () => pointing.pin(),
});
const compare = new Compare(stage, notice);
const frameNow = () => (picture.isStored ? picture.shown.frame : state.frame());
const pins = new Pins(() => readings.pins, frameNow, notice);
const nextLight = new NextLight(state, frameNow, mjd => {
    state.look({ mjd });
    timeBar.anchor();
}, notice);
const overview = new Overview(state);
const drawers = new Drawers(() => overlook());
const undo = new Undo(state, $('undo'));
new TakeAway(() => ({ ...frameNow(), samples: state.picture.samples }), () => offers.models, notice);

function atRest(frame) {
    address.write(!picture.isStored);
    undo.keep();
    layer.show(frame);
    marks.know(frame);
    contours.know(state.frame(state.movingSize), state.size);
    pointing.again();
    pointing.findGround(state);
    overview.know(frame);
    compare.know(frame);
}

/** Shows numbers and what belongs to the middle of the picture: once for all changes between two pictures of the screen. */
let isOverlooking = false;
function overlook() {
    if (!isOverlooking) {
        isOverlooking = true;
        requestAnimationFrame(() => {
            isOverlooking = false;
            overlookNow();
        });
    }
}

function overlookNow() {
    const { view, size } = state;
    panel.show();
    timeBar.show();
    const sunThere = showCompass(view, size, sun.position);
    timeBar.say(sunThere);
    nextLight.offer(sunThere);
    sun.showOver(state);
    overview.draw(sun.position);
    showScaleBar(view, size, stage.picture.clientWidth);
    sayModel(view, size, offers.models.find(({ name }) => name === state.model), state.picture);
}

const KEYS = {
    c: () => pointing.toggleCrosshair(),
    p: () => pointing.pin(),
    u: () => pointing.unpin(),
    n: () => $('north-up').click(),
    0: () => $('look-down').click(),
    l: () => layer.next(),
    g: () => marks.toggle('show-grid'),
    t: () => marks.toggle('show-terminator'),
    b: () => compare.toggleBlink(),
    h: () => drawers.switch(),
    '/': () => $('search-text').focus(),
    ',': () => timeBar.step(-1 / 24),
    '.': () => timeBar.step(1 / 24),
    '<': () => timeBar.step(-1),
    '>': () => timeBar.step(1),
    '?': () => $('help').showModal(),
    PageUp: () => frames.step(-1),
    PageDown: () => frames.step(1),
    ' ': () => (frames.states.length ? frames.togglePlay() : timeBar.togglePlay()),
    Escape: () => pointing.crosshair && pointing.toggleCrosshair(),
};

document.addEventListener('keydown', event => {
    const isTyping = event.target.closest('input, select, textarea');
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z' && !isTyping) {
        event.preventDefault();
        undo.back();
        return;
    }
    const isBusy = event.ctrlKey || event.metaKey || event.altKey || $('help').open;
    const action = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    const isHere = event.target === stage.stage || ('?/'.includes(event.key) && !isTyping);
    if (action && isHere && !isBusy) {
        event.preventDefault();
        action();
    }
});

function show(isStored) {
    aboutAddress = null;
    layer.hide();
    contours.forget();
    compare.forget();
    hover.show(null);
    if (readings.here) {
        readings.here = null;
    }
    if (!picture.shown) {
        paintSphere();
    }
    if (!isStored) {
        picture.draw();
    }
    sun.at(state.view.mjd);
    overlook();
    frames.onView();
}

stage.onPlaced = () => marks.draw();
$('crosshair').addEventListener('click', () => pointing.toggleCrosshair());
$('pin').addEventListener('click', () => pointing.pin());
$('unpin').addEventListener('click', () => pointing.unpin());
$('readings-copy').addEventListener('click', () => copy(readings.json));
$('help-open').addEventListener('click', () => $('help').showModal());
window.addEventListener('hashchange', () => tellAboutAddress(readAddress()));

function readAddress() {
    const words = address.read(offers.models);
    timeBar.anchor();
    return words;
}

function tellAboutAddress(words) {
    aboutAddress = words;
    notice(null);
}

/** What is there before the first picture: the sphere, its size and its light about right, in the shape of the pictures to come. */
function paintSphere() {
    stage.setSize(state.size);
    Stage.paintGrey(stage.image, sphereImage(state.view, state.size));
}

function showSphere() {
    readAddress();
    paintSphere();
    overlook();
}

async function start() {
    try {
        if (offers.models.length === 0) {
            offers = await getJson('/v1/models');
            state.models = offers.models;
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
        } else {
            state.draw({}); // the server is back
        }
    } catch (error) {
        notice(error.message);
        connection.lose();
    }
}

showSphere();
start();
