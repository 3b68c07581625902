<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** A 5 x 5 degree tile, named by its south-west corner. */
final class TileId
{
    /** Edge of a tile, degrees. */
    public const SIZE_DEGREES = 5;

    /**
     * @param int $southDegrees southern border: -90, -85, ... 85
     * @param int $westDegrees  western border: 0, 5, ... 355
     */
    public function __construct(public readonly int $southDegrees, public readonly int $westDegrees)
    {
    }

    /** The part of a pattern's file name that says where it is: "lat_-5_0_lon_355_360". */
    public function rangeText(): string
    {
        $north = $this->southDegrees + self::SIZE_DEGREES;
        $east = $this->westDegrees + self::SIZE_DEGREES;

        return "lat_{$this->southDegrees}_{$north}_lon_{$this->westDegrees}_$east";
    }

    /** Northernmost grid line of the tile's samples (line 0 is northernmost). */
    public function firstLine(int $pixelsPerDegree): int
    {
        return (90 - $this->southDegrees - self::SIZE_DEGREES) * $pixelsPerDegree;
    }

    /** Westernmost grid sample of the tile. */
    public function firstSample(int $pixelsPerDegree): int
    {
        return $this->westDegrees * $pixelsPerDegree;
    }
}
