<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/** Whether a label describes a cylindrical elevation model of the Moon, and agrees with itself. */
final class LdemLabelChecks
{
    /** m: both are printed to 0.1 m; a wrong sphere is off by metres. */
    private const RADIUS_TOLERANCE = 1e-3;

    /** m: a radius from here on does not fit the patterns' lattice. */
    private const RADIUS_LIMIT = 8388608.0;

    /**
     * The product is of the Moon, in simple cylindrical projection and the ME/PA frame.
     *
     * @throws BadInputException it is another product
     */
    public static function checkKind(PdsObject $root, PdsObject $map): void
    {
        self::checkText($root, 'TARGET_NAME', 'MOON', 'an elevation model of the MOON is needed');
        $isPolar = str_contains(PdsValue::wordOf($map->requiredText('MAP_PROJECTION_TYPE')), 'POLAR');
        self::checkText($map, 'MAP_PROJECTION_TYPE', 'SIMPLE CYLINDRICAL', $isPolar
            ? "polar products can't be used; take a SIMPLE CYLINDRICAL one (LDEM_4, LDEM_16, LDEM_64)"
            : 'SIMPLE CYLINDRICAL is needed');
        self::checkText($map, 'POSITIVE_LONGITUDE_DIRECTION', 'EAST', 'EAST is needed');
        self::checkNumber($map, 'MAP_PROJECTION_ROTATION', 0.0);
        if (!str_contains(PdsValue::wordOf($map->requiredText('COORDINATE_SYSTEM_NAME')), 'MEAN_EARTH')) {
            throw $map->unfit(
                'COORDINATE_SYSTEM_NAME',
                $map->required('COORDINATE_SYSTEM_NAME'),
                'the MEAN EARTH/POLAR AXIS frame is needed'
            );
        }
    }

    /**
     * Lines and samples fill the borders at the resolution, and the projection's offsets say the same.
     *
     * @throws BadInputException they don't
     */
    public static function checkCover(LdemLabel $label, PdsObject $image, PdsObject $map): void
    {
        self::checkBorders($label, $map);
        $resolution = $label->pixelsPerDegree;
        self::checkCount($image, 'LINES', $label->lines, $label->northDegrees - $label->southDegrees, $resolution);
        self::checkCount($image, 'LINE_SAMPLES', $label->lineSamples, $label->eastDegrees - $label->westDegrees, $resolution);
        self::checkNumber($map, 'LINE_FIRST_PIXEL', 1.0, PdsUnit::PIXEL);
        self::checkNumber($map, 'LINE_LAST_PIXEL', (float) $label->lines, PdsUnit::PIXEL);
        self::checkNumber($map, 'SAMPLE_FIRST_PIXEL', 1.0, PdsUnit::PIXEL);
        self::checkNumber($map, 'SAMPLE_LAST_PIXEL', (float) $label->lineSamples, PdsUnit::PIXEL);
        $centreLatitude = $map->requiredNumber('CENTER_LATITUDE', PdsUnit::DEGREE);
        $centreLongitude = $map->requiredNumber('CENTER_LONGITUDE', PdsUnit::DEGREE);
        $lineOffset = (($label->northDegrees - $centreLatitude) * $resolution) - 0.5;
        $sampleOffset = (($centreLongitude - $label->westDegrees) * $resolution) - 0.5;
        self::checkNumber($map, 'LINE_PROJECTION_OFFSET', $lineOffset, PdsUnit::PIXEL);
        self::checkNumber($map, 'SAMPLE_PROJECTION_OFFSET', $sampleOffset, PdsUnit::PIXEL);
    }

    /**
     * Every sample value that the label allows gives a radius, over a sphere that the map has too; no other bytes lie
     * between the samples.
     *
     * @throws BadInputException it is not so
     */
    public static function checkSamples(LdemLabel $label, PdsObject $image, PdsObject $map): void
    {
        self::checkNumber($image, 'BANDS', 1.0);
        self::checkNumber($image, 'LINE_PREFIX_BYTES', 0.0);
        self::checkNumber($image, 'LINE_SUFFIX_BYTES', 0.0);
        self::checkText($image, 'ENCODING_TYPE', 'N/A', 'an image without compression is needed');
        if ($label->scalingFactor <= 0.0) {
            throw $image->unfit('SCALING_FACTOR', $image->required('SCALING_FACTOR'), 'a number above 0 is needed');
        }
        $fitsType = !$label->sampleType->isInteger() || ($label->minimum >= -32768.0 && $label->maximum <= 32767.0);
        if (!$fitsType || $label->minimum > $label->maximum) {
            throw $image->unfit('MINIMUM', $image->required('MINIMUM'), 'with MAXIMUM = ' . $image->required('MAXIMUM')
                . ' no ' . 8 * $label->sampleType->bytes() . '-bit sample can be right');
        }
        $lowest = $label->offset + ($label->scalingFactor * $label->minimum);
        $highest = $label->offset + ($label->scalingFactor * $label->maximum);
        if (!($lowest > 0.0 && $highest < self::RADIUS_LIMIT)) {
            throw $image->unfit(
                'OFFSET',
                $image->required('OFFSET'),
                'with MINIMUM, MAXIMUM and SCALING_FACTOR this gives no radius of the Moon'
            );
        }
        foreach (['A_AXIS_RADIUS', 'B_AXIS_RADIUS', 'C_AXIS_RADIUS'] as $axis) {
            $radius = $map->optionalNumber($axis, PdsUnit::KILOMETRE);
            if ($radius !== null && abs((1000.0 * $radius) - $label->offset) > self::RADIUS_TOLERANCE) {
                throw $map->unfit($axis, $map->required($axis), "the heights are over a sphere of $label->offset m (OFFSET)");
            }
        }
    }

    /**
     * The file's records hold the image: exactly, if there is nothing else in the file.
     *
     * @throws BadInputException they hold more or less
     */
    public static function checkRecords(LdemLabel $label, PdsObject $file, bool $isDetached): void
    {
        $needed = $label->imageOffset + $label->imageBytes();
        $found = $label->fileBytes;
        if ($found !== null && ($found < $needed || ($isDetached && $label->imageOffset === 0 && $found !== $needed))) {
            throw $file->unfit(
                'FILE_RECORDS',
                $file->required('FILE_RECORDS'),
                'with RECORD_BYTES = ' . $file->required('RECORD_BYTES') . " these are $found bytes, but the image needs $needed"
                . ' (LINES x LINE_SAMPLES x SAMPLE_BITS / 8)'
            );
        }
    }

    /** A part of the Moon lies on the whole Moon's grid, within it. */
    private static function checkBorders(LdemLabel $label, PdsObject $map): void
    {
        foreach (
            [
                ['MAXIMUM_LATITUDE', $label->northDegrees, -90.0, 90.0],
                ['MINIMUM_LATITUDE', $label->southDegrees, -90.0, $label->northDegrees],
                ['WESTERNMOST_LONGITUDE', $label->westDegrees, 0.0, 360.0],
                ['EASTERNMOST_LONGITUDE', $label->eastDegrees, $label->westDegrees, 360.0],
            ] as [$keyword, $degrees, $least, $greatest]
        ) {
            $steps = $degrees * $label->pixelsPerDegree;
            if ($degrees < $least || $degrees > $greatest || $steps !== floor($steps)) {
                throw $map->unfit(
                    $keyword,
                    $map->required($keyword),
                    "a border from $least to $greatest degrees on the grid of $label->pixelsPerDegree px/deg is needed"
                );
            }
        }
    }

    private static function checkCount(PdsObject $image, string $keyword, int $count, float $degrees, int $pixelsPerDegree): void
    {
        $needed = $degrees * $pixelsPerDegree;
        if ((float) $count !== $needed) {
            throw $image->unfit(
                $keyword,
                $image->required($keyword),
                "the map's borders and MAP_RESOLUTION ($degrees degrees, $pixelsPerDegree px/deg) need $needed"
            );
        }
    }

    private static function checkText(PdsObject $holder, string $keyword, string $expected, string $need): void
    {
        $value = $holder->find($keyword);
        if ($value !== null && $value->word() !== PdsValue::wordOf($expected)) {
            throw $holder->unfit($keyword, $value, $need);
        }
    }

    private static function checkNumber(PdsObject $holder, string $keyword, float $expected, ?string $unit = null): void
    {
        $number = $holder->optionalNumber($keyword, $unit);
        if ($number !== null && $number !== $expected) {
            throw $holder->unfit($keyword, $holder->required($keyword), "the rest of the label needs $expected");
        }
    }
}
