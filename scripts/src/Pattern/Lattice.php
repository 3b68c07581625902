<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Numerics\DegreeTrigonometry;

/** The lattice of 2^-7 m on which every vertex of the Moon's surface lies; a point is [x, y, z] in steps, MOON_ME axes. */
final class Lattice
{
    /** Steps in a metre. */
    public const STEPS_PER_METRE = 128.0;

    /** m: LOLA's reference radius. */
    private const REFERENCE_RADIUS = 1737400.0;

    /** m: a radius from here on does not fit (its steps would pass 2^30). */
    private const RADIUS_LIMIT = 1 << 23;

    /** From this size on an offset would not be exact as a 32-bit float, which is how POV-Ray keeps vertices. */
    private const OFFSET_LIMIT = 1 << 24;

    /**
     * The lattice point nearest to a point of the surface; half steps go up, also below zero. The order of the products
     * is part of the pattern format.
     *
     * @param float                $radius    m
     * @param array{float, float}  $latitude  sine and cosine
     * @param array{float, float}  $longitude sine and cosine
     *
     * @return array{int, int, int}
     */
    public static function nearest(float $radius, array $latitude, array $longitude): array
    {
        $steps = self::STEPS_PER_METRE * $radius;
        $equatorial = $steps * $latitude[1];

        return [
            (int) floor($equatorial * $longitude[1] + 0.5),
            (int) floor($equatorial * $longitude[0] + 0.5),
            (int) floor($steps * $latitude[0] + 0.5),
        ];
    }

    /**
     * The point from which a tile's vertices count: the one nearest to its middle on the reference sphere.
     *
     * @return array{int, int, int}
     */
    public static function originOf(TileId $tile): array
    {
        $latitude = 2 * $tile->southDegrees + TileId::SIZE_DEGREES;
        $longitude = 2 * $tile->westDegrees + TileId::SIZE_DEGREES;

        return self::nearest(
            self::REFERENCE_RADIUS,
            [DegreeTrigonometry::sin($latitude, 2), DegreeTrigonometry::cos($latitude, 2)],
            [DegreeTrigonometry::sin($longitude, 2), DegreeTrigonometry::cos($longitude, 2)],
        );
    }

    /**
     * Refuses radii whose points might be too far from the origin. Each coordinate is a product of a radius and a sine
     * or cosine, and rounding is monotonic: the corners of the ranges bound all points between them.
     *
     * @param array{int, int, int}       $origin
     * @param non-empty-list<float>      $radii    m
     * @param array{float, float}        $latitude sine and cosine
     * @param non-empty-list<float>      $sines    of the longitudes
     * @param non-empty-list<float>      $cosines  of the longitudes
     */
    public static function requireReach(array $origin, array $radii, array $latitude, array $sines, array $cosines): void
    {
        foreach ([min($radii), max($radii)] as $radius) {
            if (!($radius > 0.0 && $radius < self::RADIUS_LIMIT)) {
                throw self::outOfReach($radius);
            }
            foreach ([[min($sines), min($cosines)], [max($sines), max($cosines)]] as $longitude) {
                foreach (self::nearest($radius, $latitude, $longitude) as $axis => $steps) {
                    if (abs($steps - $origin[$axis]) >= self::OFFSET_LIMIT) {
                        throw self::outOfReach($radius);
                    }
                }
            }
        }
    }

    private static function outOfReach(float $radius): BadInputException
    {
        return new BadInputException(
            "The elevation model has the radius $radius m; a surface within about 20 km of "
            . self::REFERENCE_RADIUS . ' m is needed. Check the model and its label, and import it again.',
        );
    }
}
