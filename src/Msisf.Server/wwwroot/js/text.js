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

/** The nearest of 1, 2, 5, 10, 20, ... that is not above a number. */
export function roundBelow(number) {
    const power = 10 ** Math.floor(Math.log10(number));
    const digit = number / power;
    return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
}
