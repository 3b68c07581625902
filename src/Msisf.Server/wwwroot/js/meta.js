// The numbers of a meta file, as docs/formats.md describes it.

const LABELS = {
    SimulationTime: 'Time', CameraPosition: 'Camera position', CameraOrientation: 'Camera orientation', SunPosition: 'Sun position',
    FlightAltitude: 'Flight altitude', HeightOverTerrain: 'Height over the terrain', SurfaceResolution: 'Surface resolution',
    ElevationModel: 'Elevation model', FOV: 'Field of view', MSISVersion: 'Version of msis', CommandLine: 'Command line',
};

/** A number of the file in its shortest form: +2.000000000000000E+006 is 2000000. */
const plain = text => (/^[+-]\d\.\d{15}E[+-]\d{3}$/.test(text) ? String(Number(text)) : text);

function valueOf(element) {
    if (element.nodeName === 'ElevationModel') {
        return `${element.getAttribute('product')}, drawn at ${element.getAttribute('drawnFinest')} px/deg`;
    }
    const texts = element.children.length === 0
        ? [plain(element.textContent.trim())]
        : [...element.children].map(child => (child.attributes.length === 0
            ? plain(child.textContent.trim())
            : [...child.attributes].map(({ name, value }) => `${name} ${plain(value)}`).join(', ')));
    return [texts.join(', '), element.getAttribute('unit')].filter(Boolean).join(' ');
}

/** Names and values of a meta file's general information, and how many pixels it has. */
export function metaRows(xml) {
    const file = new DOMParser().parseFromString(xml, 'application/xml');
    const rows = Object.entries(LABELS)
        .map(([name, label]) => [label, file.querySelector(`GeneralInformation > ${name}`)])
        .filter(([, element]) => element)
        .map(([label, element]) => [label, valueOf(element)]);
    return [...rows, ['Pixels in the meta file', String(file.querySelectorAll('PixelInformation > Pixel').length)]];
}
