<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/**
 * The first line of a pattern file. It says what the file holds, ties it to the radii that it was made from, and carries
 * the file's length, so that reading it is enough to know whether the file is the wanted one and whole.
 */
final class PatternHeader
{
    /** What every pattern of MSISF begins with. */
    public const MARK = '// msisf-pattern ';

    /** Digits of the file's length, with leading zeros: the length of the header does not depend on it. */
    public const LENGTH_DIGITS = 12;

    private const FORMAT_VERSION = 1;

    /** The header up to the file's length: equal for equal content. */
    public static function withoutLength(
        TileMeshLayout $layout,
        TileRadii $radii,
        string $productId,
        PatternFormat $format,
    ): string {
        return self::MARK . self::FORMAT_VERSION
            . " format=$format->value product=$productId res=$layout->pixelsPerDegree tile={$layout->tile->rangeText()}"
            . " margin-samples=$layout->marginSamples samples-sha256={$radii->hash()}"
            . " vertices={$layout->vertexCount()} faces={$layout->faceCount()} bytes=";
    }

    /** The file's length as it ends the header. */
    public static function length(int $bytes): string
    {
        return sprintf('%0' . self::LENGTH_DIGITS . 'd', $bytes);
    }
}
