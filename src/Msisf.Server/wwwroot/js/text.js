// Numbers as people read them: pure functions.

const UNDEFINED = '–';

/** A number with a fixed count of decimals and a true minus sign. */
export function fixed(number, decimals) {
    if (number === null || number === undefined || !Number.isFinite(number)) {
        return UNDEFINED;
    }
    const text = Math.abs(number).toFixed(decimals);
    return number < 0 && Number(text) !== 0 ? `−${text}` : text;
}

/** An angle in degrees. */
export const degrees = (angle, decimals = 3) => (angle === null || angle === undefined ? UNDEFINED : `${fixed(angle, decimals)}°`);

/** 12.345678° N */
export const latitudeText = latitude => `${fixed(Math.abs(latitude), 6)}° ${latitude < 0 ? 'S' : 'N'}`;

/** A length of any size, in m or km, with the digits that matter. */
export function lengthText(metres) {
    const size = Math.abs(metres);
    if (!(size >= 0)) {
        return UNDEFINED;
    }
    return size < 10 ? `${fixed(metres, 3)} m`
        : size < 1000 ? `${fixed(metres, 1)} m`
        : size < 1e6 ? `${fixed(metres / 1000, 3)} km`
        : `${fixed(metres / 1000, 1)} km`;
}

/** An area in m or km squared, with the digits that matter. */
export const areaText = area => (area < 1e6 ? `${fixed(area, 0)} m²` : `${fixed(area / 1e6, area < 1e10 ? 2 : 0)} km²`);

/** The nearest of 1, 2, 5, 10, 20, ... that is not above a number. */
export function roundBelow(number) {
    const power = 10 ** Math.floor(Math.log10(number));
    const digit = number / power;
    return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
}

const WINDS = ['N', 'NNE', 'NE', 'ENE', 'E', 'ESE', 'SE', 'SSE', 'S', 'SSW', 'SW', 'WSW', 'W', 'WNW', 'NW', 'NNW'];

/** The wind from which an azimuth points: 67 is ENE. */
export const windOf = azimuth => WINDS[Math.round(azimuth / 22.5) % 16];

/** A longitude as chosen: 348.62° E, or 11.38° W. */
export function longitudeText(longitude, decimals, isHalved) {
    const east = longitude % 360 > 180 ? longitude % 360 - 360 : longitude % 360;
    return isHalved ? `${fixed(Math.abs(east), decimals)}° ${east < 0 ? 'W' : 'E'}` : `${fixed(longitude, decimals)}° E`;
}

/** 43.312° S 348.621° E */
export const placeText = ({ latitude, longitude }, isHalved, decimals = 3) =>
    `${fixed(Math.abs(latitude), decimals)}° ${latitude < 0 ? 'S' : 'N'}  ${longitudeText(longitude, decimals, isHalved)}`;

/** The place that a text names in numbers, such as 43.3 S 11.2 W or -43.3, 348.8; null where it is none. */
export function placeOfText(text) {
    const match = /^\s*([-−+]?\d+(?:\.\d*)?)\s*°?\s*([NS])?[\s,]+([-−+]?\d+(?:\.\d*)?)\s*°?\s*([EW])?\s*$/i.exec(text);
    if (!match) {
        return null;
    }
    const [, phi, northSouth, lambda, eastWest] = match;
    const number = (digits, letter, negative) => Number(digits.replace('−', '-')) * (letter?.toUpperCase() === negative ? -1 : 1);
    const [latitude, longitude] = [number(phi, northSouth, 'S'), number(lambda, eastWest, 'W')];
    return Math.abs(latitude) <= 90 && Math.abs(longitude) <= 360 ? { latitude, longitude: (longitude + 360) % 360 } : null;
}

/** How many samples a pixel has: 1 sample a pixel, 4 samples a pixel, or as many as it needs. */
export const samplesText = count => (count === 'auto' ? 'samples as needed' : `${count} ${count === 1 ? 'sample' : 'samples'} a pixel`);

/** A number of pictures: 1 picture, 2 pictures. */
export const picturesText = count => `${count} ${count === 1 ? 'picture' : 'pictures'}`;
