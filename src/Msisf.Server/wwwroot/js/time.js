// Modified Julian Dates (UTC, no leap seconds) and the calendar: pure functions.

const MILLISECONDS_A_DAY = 86400000;
const MJD_OF_1970 = 40587;

/** The MJD of a time of the calendar such as 2010-04-06T20:24:00Z, or of the start of a day such as 2010-04-06; null where it is none. */
export function mjdOf(text) {
    const match = /^(\d{4})-(\d\d)-(\d\d)(?:T(\d\d):(\d\d)(?::(\d\d(?:\.\d+)?))?Z?)?$/.exec(text.trim());
    if (!match) {
        return null;
    }
    const [year, month, day, hour, minute] = match.slice(1, 6).map(part => Number(part ?? 0));
    const seconds = Number(match[6] ?? 0);
    const date = new Date(0);
    date.setUTCFullYear(year, month - 1, day); // Date.UTC takes the years 0 to 99 for those of the 20th century
    if (year === 0 || date.getUTCMonth() !== month - 1 || hour > 23 || minute > 59 || seconds >= 60) {
        return null;
    }
    return MJD_OF_1970 + date.getTime() / MILLISECONDS_A_DAY + (hour * 3600 + minute * 60 + seconds) / 86400;
}

/** The time of the calendar of an MJD, to the nearest second, without its Z: 2010-04-06T20:24:00. */
export function calendarOf(mjd) {
    const seconds = Math.round((mjd - MJD_OF_1970) * 86400);
    return new Date(seconds * 1000).toISOString().slice(0, 19);
}
