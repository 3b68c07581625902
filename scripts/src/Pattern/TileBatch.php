<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** Neighbouring tiles of a row, whose samples are read at once: far faster than tile by tile, and border lines are read once. */
final class TileBatch
{
    /** Samples to read at once: about 8 MB of PHP's memory. A single tile may have more. */
    private const MOST_SAMPLES = 1 << 19;

    /** @param non-empty-list<TileMeshLayout> $layouts from west to east */
    private function __construct(public readonly array $layouts)
    {
    }

    /**
     * Cuts tiles into batches.
     *
     * @param list<TileId> $tiles by latitude, then longitude
     *
     * @return list<self>
     */
    public static function cut(array $tiles, int $pixelsPerDegree, int $marginSamples): array
    {
        $batches = [];
        $layouts = [];
        foreach ($tiles as $tile) {
            $layout = TileMeshLayout::for($tile, $pixelsPerDegree, $marginSamples);
            if ($layouts !== [] && !self::canGrow($layouts, $layout)) {
                $batches[] = new self($layouts);
                $layouts = [];
            }
            $layouts[] = $layout;
        }
        if ($layouts !== []) {
            $batches[] = new self($layouts);
        }

        return $batches;
    }

    /** Reads all samples that the batch's tiles need. */
    public function read(RadiusSource $source): SampleBlock
    {
        $first = $this->layouts[0];

        return SampleBlock::read(
            $source,
            $first->firstLine,
            $first->lines,
            $first->firstSample,
            self::width($this->layouts),
        );
    }

    /** @param non-empty-list<TileMeshLayout> $layouts */
    private static function canGrow(array $layouts, TileMeshLayout $next): bool
    {
        $last = $layouts[count($layouts) - 1]->tile;

        return $last->southDegrees === $next->tile->southDegrees
            && $last->westDegrees + TileId::SIZE_DEGREES === $next->tile->westDegrees
            && self::width([...$layouts, $next]) * $next->lines <= self::MOST_SAMPLES;
    }

    /** @param non-empty-list<TileMeshLayout> $layouts */
    private static function width(array $layouts): int
    {
        $size = TileId::SIZE_DEGREES * $layouts[0]->pixelsPerDegree;

        return $layouts[0]->samples + (count($layouts) - 1) * $size;
    }
}
