<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use InvalidArgumentException;

/**
 * Which samples a tile's mesh joins and in which order. Vertices: the north pole, if the mesh reaches it; then the
 * samples line by line from the north, each from the west; then the south pole. A cell of four samples belongs to the
 * tile that holds its north-west sample, so each cell of the Moon belongs to exactly one tile.
 */
final class TileMeshLayout
{
    /**
     * @param int $marginSamples rings of cells around the tile that are added; usually 0
     * @param int $firstLine     northernmost line of the grid
     * @param int $firstSample   westernmost sample of the grid, in [0, 360 res)
     * @param int $samples       samples a line; they go on over the prime meridian
     */
    private function __construct(
        public readonly TileId $tile,
        public readonly int $pixelsPerDegree,
        public readonly int $marginSamples,
        public readonly int $firstLine,
        public readonly int $lines,
        public readonly int $firstSample,
        public readonly int $samples,
    ) {
    }

    /** @param int $marginSamples 0 to the samples of a degree; rings beyond a pole are left out */
    public static function for(TileId $tile, int $pixelsPerDegree, int $marginSamples): self
    {
        if ($pixelsPerDegree < 1 || $marginSamples < 0 || $marginSamples > $pixelsPerDegree) {
            throw new InvalidArgumentException("No layout for $pixelsPerDegree px/deg and a margin of $marginSamples samples.");
        }
        $size = TileId::SIZE_DEGREES * $pixelsPerDegree;
        $allLines = 180 * $pixelsPerDegree;
        $allSamples = 360 * $pixelsPerDegree;

        // One line and one sample more than cells: the south-east corners of the last ones lie in the next tile.
        $firstLine = max($tile->firstLine($pixelsPerDegree) - $marginSamples, 0);
        $endLine = min($tile->firstLine($pixelsPerDegree) + $size + $marginSamples + 1, $allLines);
        $firstSample = ($tile->firstSample($pixelsPerDegree) - $marginSamples + $allSamples) % $allSamples;

        return new self(
            $tile,
            $pixelsPerDegree,
            $marginSamples,
            $firstLine,
            $endLine - $firstLine,
            $firstSample,
            $size + 2 * $marginSamples + 1,
        );
    }

    /** The mesh ends in a fan around the north pole. */
    public function hasNorthPole(): bool
    {
        return $this->firstLine === 0;
    }

    /** The mesh ends in a fan around the south pole. */
    public function hasSouthPole(): bool
    {
        return $this->firstLine + $this->lines === 180 * $this->pixelsPerDegree;
    }

    /** Vertices of samples and poles. */
    public function vertexCount(): int
    {
        return $this->lines * $this->samples + (int) $this->hasNorthPole() + (int) $this->hasSouthPole();
    }

    /** Triangles. */
    public function faceCount(): int
    {
        return ($this->samples - 1)
            * (2 * ($this->lines - 1) + (int) $this->hasNorthPole() + (int) $this->hasSouthPole());
    }
}
